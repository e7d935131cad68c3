// Prints the motion of jointed slopes in 0.4 s under profile `standard`, and fails if one gains energy, rises or
// swells. The slopes of the Berkeley program's runs come from ../shared, if that folder is there; those drawn here need
// none.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <array>

#include "formats/case.hpp"
#include "tests/support/shared_folder.hpp"
#include "tests/validate/convergence.hpp"

namespace keyblock {
namespace {

// Contact forces are solved to a millionth of the largest load: the accuracy of energy over m g h.
constexpr double kMostExcess = 1e-6;
constexpr double kMostRise = 1e-6;
constexpr double kMostAreaChange = 1e-3;
constexpr double kMostOverlap = 1e-3;

// Two joint sets, face of 60 degrees, friction 20: 45, 175, 516 blocks.
constexpr std::array<const char*, 3> kSharedSlopes{"5", "10", "20"};
// Drawn with separate base and back, and with both in one block.
constexpr std::array<std::uint64_t, 4> kOwnSlopes{11, 19, 1, 13};

std::vector<RandomScene> slopes() {
  std::vector<RandomScene> scenes;
  for (const std::uint64_t seed : kOwnSlopes) scenes.push_back(random_slope(seed));
  const std::filesystem::path folder = shared_folder() / "reference_runs" / "scaling";
  for (const std::string size : kSharedSlopes) {
    const std::string geometry = (folder / ("slope" + size + ".geo")).string();
    if (!std::filesystem::exists(geometry)) {
      fmt::print("skipped: {} is not there\n", geometry);
      continue;
    }
    scenes.push_back(
        {"slope" + size, formats::load_case({geometry, (folder / ("slope_N" + size + ".ana")).string()}).problem});
  }
  return scenes;
}

bool holds(const SceneRun& run) {
  return run.end == End::finished && run.all_finite && run.energy_ratio <= 1 && run.energy_excess <= kMostExcess &&
         run.rise <= kMostRise && run.area_change <= kMostAreaChange && run.overlap <= kMostOverlap;
}

}  // namespace
}  // namespace keyblock

int main() {
  using namespace keyblock;
  fmt::print("{:<10} {:>7} {:>6} {:>10} {:>12} {:>9} {:>9} {:>9} {:>9} {:>9}  {}\n", "slope", "blocks", "steps",
             "T/released", "T-released", "gain", "rise", "area", "overlap", "seconds", "verdict");
  int misses = 0;
  for (RandomScene& scene : slopes()) {
    scene.problem.analysis->step_count = 200;
    scene.problem.analysis->time_step = 2e-3;
    const SceneRun run = run_scene(scene, "standard", {});
    fmt::print("{:<10} {:>7} {:>6} {:>10.3f} {:>12.2g} {:>9.2g} {:>9.2g} {:>9.2g} {:>9.2g} {:>9.1f}  {}\n", run.scene,
               run.blocks, run.made, run.energy_ratio, run.energy_excess, run.energy_gain, run.rise, run.area_change,
               run.overlap, run.seconds,
               holds(run) ? "holds" : "misses" + (run.reason.empty() ? "" : ": " + run.reason));
    misses += holds(run) ? 0 : 1;
  }
  return misses == 0 ? 0 : 1;
}
