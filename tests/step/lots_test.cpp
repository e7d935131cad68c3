// Blocks far from others: what statics and the start find for them does not depend on the others.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/lots.hpp"

#include <gtest/gtest.h>

#include "tests/support/standard_scenes.hpp"

namespace keyblock {
namespace {

using support::rectangle;
using support::travel;
using support::turned_rectangle;

void add(Blocks& scene, BlockPolygon block, int material) {
  block.material = material;
  scene.blocks.push_back(std::move(block));
}

// Two fixed points on the diagonal of a rectangle.
void fix_last(Blocks& scene) {
  const std::vector<BlockVertex>& corners = scene.blocks.back().outer;
  const int block = static_cast<int>(scene.blocks.size()) - 1;
  const Point along = corners[2].position - corners[0].position;
  for (const double part : {0.2, 0.8}) scene.fixed_points.push_back({corners[0].position + part * along, block, {}});
}

// A column of three blocks of 5 cm on a floor, the top pushed to 0.11 m/s, friction 45; far away, if asked for, a block
// of 10 m under stress in a fixed shaft.
Scene column(bool has_neighbour) {
  Analysis analysis = support::plain_analysis(1e-3, 20);
  analysis.joint_materials[0].friction_angle_deg = 45;
  BlockMaterial rock = analysis.block_materials[0];
  rock.youngs_modulus = 6e10;
  rock.poissons_ratio = 0.2;
  BlockMaterial pushed = rock, stressed = rock;
  pushed.initial_velocity = {0.11, 0, 0};
  stressed.initial_stress = {-1.5e6, -1.5e6, 0};
  analysis.block_materials = {rock, pushed, stressed};
  Blocks scene;
  add(scene, rectangle({-1.5, -0.5}, {1.5, 0}), 0);
  fix_last(scene);
  for (int k = 0; k < 3; ++k) add(scene, rectangle({0, 0.05 * k}, {0.05, 0.05 * (k + 1)}), k == 2 ? 1 : 0);
  if (has_neighbour) {
    add(scene, rectangle({90, -1}, {120, 0}), 0);
    fix_last(scene);
    for (const double left : {90.0, 110.0}) {
      add(scene, rectangle({left, 0}, {left + 10, 10}), 0);
      fix_last(scene);
    }
    add(scene, rectangle({100, 0}, {110, 10}), 2);
  }
  return support::standard_scene_of(scene, analysis, support::standard_settings(analysis));
}

// Block of 10 cm on a slope of 30 degrees with friction 20; if asked for, a block of 100 m stands far away.
Scene sliding(bool has_neighbour) {
  Analysis analysis = support::plain_analysis(1e-3, 1);
  analysis.joint_materials[0].friction_angle_deg = 20;
  const double slope = support::radians(30);
  Blocks scene;
  add(scene, turned_rectangle({-0.8, -0.2}, {0.8, 0}, slope), 0);
  fix_last(scene);
  add(scene, turned_rectangle({0, 0}, {0.1, 0.1}, slope), 0);
  if (has_neighbour) {
    add(scene, rectangle({100, -10}, {300, 0}), 0);
    fix_last(scene);
    add(scene, rectangle({150, 0}, {250, 100}), 0);
  }
  Settings settings = support::standard_settings(analysis);
  settings.standard.motion = MotionRule::equilibrium;
  return support::standard_scene_of(scene, analysis, settings);
}

// The start moved the top by twice its size: steps of a start that fit the block of 10 m were too long for 5 cm.
TEST(Lots, a_column_moves_as_it_does_without_a_stressed_block_far_away) {
  StandardStepper alone(column(false)), together(column(true));
  for (StandardStepper* stepper : {&alone, &together}) support::run_to(*stepper, 0.02);
  for (const int e : {1, 2, 3})
    EXPECT_LT(length(travel(together, together.unloaded(), e) - travel(alone, alone.unloaded(), e)), 1e-6 * 0.05) << e;
}

// It was called an equilibrium after 65 % of the block's size: its load is a millionth of the other's.
TEST(Lots, a_small_block_that_slides_is_named_beside_a_large_one_at_rest) {
  for (const bool has_neighbour : {false, true}) {
    StandardStepper stepper(sliding(has_neighbour));
    const auto made = stepper.advance();
    const auto* failure = std::get_if<StepFailure>(&made);
    ASSERT_NE(failure, nullptr) << has_neighbour;
    EXPECT_EQ(failure->elements, std::vector<ElementIndex>{ElementIndex{1}}) << has_neighbour;
  }
}

TEST(Lots, sets_of_similar_force_and_sets_that_touch_are_one_lot) {
  const auto lots_beside = [](double side, double left) {
    Analysis analysis = support::plain_analysis(1e-3, 1);
    Blocks scene;
    add(scene, rectangle({-1, -1}, {200, 0}), 0);
    fix_last(scene);
    add(scene, rectangle({0, 0}, {1, 1}), 0);
    add(scene, rectangle({left, 0}, {left + side, side}), 0);
    const StandardScene made =
        standard_scene(support::standard_scene_of(scene, analysis, support::standard_settings(analysis)));
    return lots_of(made, start_motion(made), 0);
  };
  EXPECT_TRUE(lots_beside(2, 100).empty());  // four times the weight
  EXPECT_TRUE(lots_beside(50, 1).empty());
  EXPECT_EQ(lots_beside(50, 100), (std::vector<ChosenElements>{{false, true, false}, {false, false, true}}));
}

}  // namespace
}  // namespace keyblock
