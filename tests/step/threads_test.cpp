// Steps of a wall large enough for iterations and for threads in every loop: the same motion to the last bit.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "base/context.hpp"
#include "base/loop.hpp"
#include "run/steppers.hpp"
#include "step/standard_stepper.hpp"
#include "tests/bench/bench_scenes.hpp"

namespace keyblock::step_threads_test {
namespace {

class Threads : public ::testing::TestWithParam<const char*> {
 protected:
  ~Threads() override { context().use_threads(0); }

  /// Vertices after some steps of a suddenly loaded wall of 1,121 bricks.
  static Table<VertexIndex, Point> after_steps(const std::string& profile, int threads) {
    context().use_threads(threads);
    Scene scene = bench::scene_for(bench::brick_wall(33), profile);
    scene.settings.standard.start = StartRule::sudden;
    const std::unique_ptr<Stepper> stepper = stepper_for(scene);
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(std::holds_alternative<StepReport>(stepper->advance()));
    return stepper->state().vertices;
  }
};

TEST_P(Threads, make_the_same_motion_to_the_last_bit) {
  const auto one = after_steps(GetParam(), 1);
  for (const int threads : {2, 4}) EXPECT_TRUE(one == after_steps(GetParam(), threads)) << threads;
}

// Bricks so weak that they yield under their first weight.
TEST(ThreadsOfYieldingBlocks, make_the_same_motion_to_the_last_bit) {
  const auto after_steps = [](int threads) {
    context().use_threads(threads);
    const Blocks wall = bench::brick_wall(33);
    Analysis analysis = bench::scaling_analysis(wall);
    Strength strength;
    strength.surface = YieldSurface::tresca;
    strength.values.cohesion = 300;
    analysis.block_materials[0].strength = std::make_shared<const Strength>(strength);
    Settings settings = profile_settings("standard", analysis);
    settings.standard.start = StartRule::sudden;
    const std::unique_ptr<Stepper> stepper = stepper_for(support::standard_scene_of(wall, analysis, settings));
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(std::holds_alternative<StepReport>(stepper->advance()));
    EXPECT_GT(stepper->plastic_totals()->yielded, 0);
    return stepper->state().vertices;
  };
  const auto one = after_steps(1);
  for (const int threads : {2, 4}) EXPECT_TRUE(one == after_steps(threads)) << threads;
  context().use_threads(0);
}

INSTANTIATE_TEST_SUITE_P(Profiles, Threads, ::testing::Values("legacy", "standard"));

}  // namespace
}  // namespace keyblock::step_threads_test
