// Random stacks and slopes in small: drawn alike every time, replayed from their files, and every step of profile
// `standard` converges. `make validate` has the full count.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/validate/random_scenes.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "formats/case.hpp"
#include "tests/validate/shares.hpp"

namespace keyblock::random_scenes_test {
namespace {

constexpr int kScenes = 100;  // of 40 steps: one step in a thousand is then two

/// Slopes have 5 to 60 blocks, and stacks 2 to 12, beside their supports.
void expect_blocks_within_bounds(const SceneRun& run) {
  const bool is_slope = run.scene.starts_with("slope");
  EXPECT_GE(run.blocks, 1 + (is_slope ? kFewestBlocksOfSlope : 2)) << run.scene;
  EXPECT_LE(run.blocks, is_slope ? 2 + kMostBlocksOfSlope : 1 + 12) << run.scene;
}

}  // namespace

// CTest runs each test by itself: one test has all that these runs show.
TEST(RandomScenes, profile_standard_converges_without_cutting_and_never_ends_early) {
  const std::vector<SceneRun> runs = run_scenes(0, kScenes, 2);
  for (const std::string& miss : misses_of_standard(shares_of(runs))) ADD_FAILURE() << miss;
  for (const SceneRun& run : runs) {
    if (run.end != End::refused) expect_blocks_within_bounds(run);
    if (run.profile != "standard") continue;
    EXPECT_EQ(run.end, End::finished) << run.scene << ": " << run.reason;
    EXPECT_TRUE(run.all_finite) << run.scene;
  }
}

// These slopes must not gain energy, nor their centre of mass rise. Strain rates made into rigid velocity, and overlaps
// pushed out within a step, once gave them 1.5e-3, 5.6e-4 and 1e-5 of m g h.
TEST(RandomScenes, slopes_of_short_steps_gain_no_energy) {
  std::vector<SceneRun> runs;
  for (const std::uint64_t seed : {43, 23, 117})
    runs.push_back(run_scene(random_slope(seed), "standard", constant_step()));
  for (const std::string& miss : misses_of_standard(shares_of(runs))) ADD_FAILURE() << miss;
}

// Round-off may cut the first step of this slope: its first acceleration once moved a sliver by 55 times its size.
// Steps that differ by a billionth have other round-off.
TEST(RandomScenes, a_sliver_sent_off_by_its_acceleration_cuts_no_step) {
  RandomScene scene = random_slope(117);
  scene.problem.analysis->step_count = 4;
  const double step = scene.problem.analysis->time_step;
  for (int i = 0; i < 12; ++i) {
    scene.problem.analysis->time_step = (1 + i * 1e-9) * step;
    const SceneRun run = run_scene(scene, "standard", constant_step());
    EXPECT_EQ(run.cut, 0) << "with the step " << scene.problem.analysis->time_step;
    EXPECT_EQ(run.end, End::finished) << run.reason;
  }
}

TEST(RandomScenes, results_do_not_depend_on_the_number_of_threads) {
  const std::vector<SceneRun> alone = run_scenes(0, 4, 1);
  const std::vector<SceneRun> together = run_scenes(0, 4, 2);
  ASSERT_EQ(alone.size(), together.size());
  for (std::size_t i = 0; i < alone.size(); ++i) {
    const SceneRun& beside = together[i];
    EXPECT_EQ(alone[i].scene, beside.scene);
    EXPECT_EQ(alone[i].residuals, beside.residuals) << alone[i].scene;
    EXPECT_EQ(alone[i].energy_gain, beside.energy_gain) << alone[i].scene;
  }
}

// Legacy with the native file's choices, the constant step beside them: the same run, to the bit.
TEST(RandomScenes, a_scene_replays_from_its_files) {
  const std::filesystem::path folder = std::filesystem::path(::testing::TempDir()) / "random_scenes";
  std::filesystem::create_directories(folder);
  for (const std::uint64_t seed : {2, 11}) {
    const RandomScene scene = random_scene(seed);
    write_scene(scene, folder);
    const std::string base = (folder / fmt::format("{}_{}", scene.name.substr(0, 5), seed)).string();
    const std::string geometry = base + (seed % 2 == 0 ? ".blk" : ".geo");
    const RandomScene replayed{scene.name, formats::load_case({geometry, base + ".ana"}).problem};
    for (const char* profile : {"legacy", "standard"}) {
      const SceneRun a = run_scene(scene, profile, constant_step());
      const SceneRun b = run_scene(replayed, profile, constant_step());
      EXPECT_EQ(a.passes, b.passes) << scene.name << ", " << profile;
      EXPECT_EQ(a.residuals, b.residuals) << scene.name << ", " << profile;
    }
  }
}

}  // namespace keyblock::random_scenes_test
