// The sentence of scenes whose bodies, supports and loads are counted by hand.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/batch/scene_sentence.hpp"

#include <gtest/gtest.h>

#include "tests/support/two_triangles.hpp"

namespace keyblock::study::scene_sentence_test {
namespace {

Analysis analysis() {
  Analysis analysis;
  analysis.step_count = 5;
  analysis.time_step = 0.2;
  analysis.point_loads = {{{0, 1}, {{3, -4}, {0, 1}}, {}}};
  BlockMaterial rock;
  rock.youngs_modulus = 10;
  rock.poissons_ratio = 0.24;
  rock.unit_weight = 0.07;
  analysis.block_materials = {rock};
  JointMaterial joint;
  joint.friction_angle_deg = 20;
  analysis.joint_materials = {joint, joint};
  return analysis;
}

}  // namespace

TEST(SceneSentence, pieces_are_elements_that_share_covers) {
  Cover cover = support::two_triangles();
  EXPECT_EQ(
      scene_sentence(cover, analysis()),
      "static, 5 steps of 0.2; 2 pieces, 1 of them fixed, of 2 elements on 6 covers; 1 point load of up to 5; E 10, "
      "Poisson's ratio 0.24; weight 0.07; friction 20 degrees");
  cover.elements[1].covers = {0, 5, 2};
  cover.fixed_points.clear();
  EXPECT_NE(scene_sentence(cover, analysis()).find("; 1 piece, not fixed, of 2 elements on 6 covers; "),
            std::string::npos);
}

TEST(SceneSentence, values_that_differ_are_told_as_a_range) {
  Analysis many = analysis();
  many.velocity_carry_over = 1;
  many.point_loads.clear();
  many.block_materials.push_back(many.block_materials[0]);
  many.block_materials[1].youngs_modulus = 1e6;
  for (BlockMaterial& material : many.block_materials) material.unit_weight = 0;
  many.block_materials[1].horizontal_force = -0.05;
  many.joint_materials[1].friction_angle_deg = 35;
  Blocks blocks;
  blocks.blocks.resize(3);
  blocks.fixed_points = {{{0, 0}, 2, {}}, {{1, 0}, 2, {}}};
  blocks.loading_points = {{{0, 0}, 0, {}}};
  EXPECT_EQ(
      scene_sentence(blocks, many),
      "dynamic, 5 steps of 0.2; 3 blocks, 1 of them fixed; no point load; E 10 to 1e+06, Poisson's ratio 0.24; no "
      "weight, horizontal body force -0.05 to 0; friction 20 to 35 degrees");
  many.velocity_carry_over = 0.95;
  EXPECT_TRUE(scene_sentence(blocks, many).starts_with("damped, velocities times 0.95 per step, 5 steps"));
}

}  // namespace keyblock::study::scene_sentence_test
