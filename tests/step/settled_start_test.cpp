// The settled start of jointed blocks: the blocks that carry load, and the messages about it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/rest/settled_start.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "tests/support/standard_scenes.hpp"

namespace keyblock::settled_start_test {
namespace {

using support::plain_analysis;
using support::rectangle;
using support::standard_settings;

// Four squares of a metre on a floor; `points` fix the floor.
StandardScene wall_on_floor(const std::vector<BlockPoint>& points) {
  Blocks blocks;
  blocks.blocks = {rectangle({-2, -1}, {4, 0}), rectangle({0, 0}, {1, 1}), rectangle({1, 0}, {2, 1}),
                   rectangle({0, 1}, {1, 2}), rectangle({1, 1}, {2, 2})};
  blocks.fixed_points = points;
  Analysis analysis = plain_analysis(1e-3, 1);
  analysis.joint_materials[0].friction_angle_deg = 30;
  Settings settings = standard_settings(analysis);
  settings.standard.enforcement = Enforcement::penalty;
  return standard_scene(with_bases(model_from_blocks(blocks, analysis), settings.basis), settings);
}

// Sum of the normal forces on the floor.
double on_floor(const StandardScene& scene, const Motion& motion) {
  double sum = 0;
  for (const auto& [touch, memory] : motion.closed.all())
    if (scene.model.vertices[touch.start].element == ElementIndex{0}) sum += memory.normal;
  return sum;
}

}  // namespace

// Weight of four blocks of 2500 kg, on a floor that cannot move and on one with one fixed point, which can rotate.
TEST(SettledStart, a_block_held_at_a_point_bears_what_stands_on_it) {
  for (const std::vector<BlockPoint>& points : {std::vector<BlockPoint>{{{-1, -0.5}, 0, {}}, {{3, -0.5}, 0, {}}},
                                                std::vector<BlockPoint>{{{1, -0.5}, 0, {}}}}) {
    const StandardScene scene = wall_on_floor(points);
    const Settled made = settled(scene, start_motion(scene));
    EXPECT_EQ(made.unsolved_steps, 0);
    EXPECT_NEAR(on_floor(scene, made.motion) / (4 * 2500 * 9.81), 1, 1e-3) << points.size() << " points";
  }
}

// A block hangs on a bolt, 40 mm out of plumb, from the last block of a row. No equilibrium lies near by for it, so it
// begins as drawn and swings with g sin a. Stress of a few blocks once let it begin in plumb, and glue threw it by 3 m.
TEST(SettledStart, a_block_out_of_plumb_swings_beside_a_row_at_rest) {
  for (const auto& [n, stress] : {std::pair(15, 1e6), {22, 0.0}, {40, 0.0}}) {
    constexpr double kAside = 0.04, kLength = 1.8 + 0.05;  // from the upper end of the bolt to the middle of the block
    const double x = n - 0.1;
    Blocks blocks;
    blocks.blocks = {rectangle({-2, -1}, {n - 0.3, 0}), rectangle({-2, 0}, {0, 1})};
    for (int i = 0; i < n; ++i) blocks.blocks.push_back(rectangle({i + 0.0, 0}, {i + 1.0, 1}));
    blocks.blocks.push_back(rectangle({x + kAside - 0.1, -1.8}, {x + kAside + 0.1, -1.5}));
    blocks.fixed_points = {{{-1.5, -0.5}, 0, {}}, {{n - 1.5, -0.5}, 0, {}}, {{-1.5, 0.2}, 1, {}}, {{-0.5, 0.8}, 1, {}}};
    blocks.bolts = {{{{x, 0.2}, {x + kAside, -1.6}}, n + 1, n + 2, 1e7, 0, 0}};
    Analysis analysis = plain_analysis(1e-3, 1);
    analysis.block_materials[0].youngs_modulus = 1e9;
    analysis.block_materials[0].poissons_ratio = 0;
    analysis.block_materials[0].initial_stress = {-stress, 0, 0};
    analysis.joint_materials[0].friction_angle_deg = stress > 0 ? 0 : 30;
    StandardStepper stepper(support::standard_scene_of(blocks, analysis, standard_settings(analysis)));
    const ElementIndex hung(n + 2);
    const Point start = stepper.state().elements[hung].centroid;
    EXPECT_NEAR(start.x, x + kAside, 2e-3) << n;
    if (stress > 0) continue;  // its row begins to move, too
    support::run_to(stepper, 0.1);
    const double way = start.x - stepper.state().elements[hung].centroid.x;
    const double swing = 9.81 * (kAside / kLength) * 0.1 * 0.1 / 2;
    EXPECT_NEAR(way, swing, 0.15 * swing) << n;
  }
}

TEST(SettledStart, blocks_without_support_are_left_unloaded) {
  const StandardScene scene = wall_on_floor({});
  const Settled made = settled(scene, start_motion(scene));
  EXPECT_NEAR(on_floor(scene, made.motion), 0, 1e-6);
}

// A wall of bricks upon each other: the floor carries its weight, and nothing moves in the first steps.
TEST(SettledStart, a_wall_stands_from_its_first_step_on) {
  Blocks blocks;
  blocks.blocks = {rectangle({-2, -1}, {12, 0})};
  for (int row = 0; row < 12; ++row)
    for (int i = 0; i < 5; ++i) {
      const double x = 2 * i + row % 2;
      blocks.blocks.push_back(rectangle({x, 1.0 * row}, {x + 2, row + 1.0}));
    }
  blocks.fixed_points = {{{-1, -0.5}, 0, {}}, {{11, -0.5}, 0, {}}};
  Analysis analysis = plain_analysis(2e-3, 1);
  analysis.joint_materials[0].friction_angle_deg = 30;
  analysis.contact_penalty = 50 * analysis.block_materials[0].youngs_modulus;
  Settings settings = standard_settings(analysis);
  settings.standard.enforcement = Enforcement::penalty;
  StandardStepper stepper(support::standard_scene_of(blocks, analysis, settings));
  EXPECT_EQ(stepper.start_report().unsolved_steps, 0);
  EXPECT_NEAR(on_floor(stepper.scene(), stepper.motion()) / (60 * 2 * 2500 * 9.81), 1, 1e-4);
  for (int i = 0; i < 20; ++i) ASSERT_TRUE(std::holds_alternative<StepReport>(stepper.advance()));
  double fastest = 0;
  for (const Unknowns& v : stepper.motion().v)
    if (v.size() > 0) fastest = std::max(fastest, v.head<2>().norm());
  EXPECT_LE(fastest, 1e-3 * 9.81 * 2e-3);
}

}  // namespace keyblock::settled_start_test
