// Blocks become elements whose vertices know their neighbours.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/setup/from_blocks.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/scenes.hpp"

namespace keyblock::from_blocks_test {
namespace {

using support::plain_analysis;
using support::rectangle;

BlockPolygon square_with_hole() {
  BlockPolygon block = rectangle({0, 0}, {4, 4});
  block.holes = {{{{1, 1}, 0}, {{1, 2}, 0}, {{2, 2}, 0}, {{2, 1}, 0}}};
  return block;
}

}  // namespace

TEST(FromBlocks, vertices_of_a_hole_are_linked_within_their_own_loop) {
  const Model model = model_from_blocks({{square_with_hole()}, {}, {}, {}, {}, {}}, plain_analysis(1e-3, 1));
  ASSERT_EQ(model.vertices.size(), 8U);
  EXPECT_EQ(model.vertices[VertexIndex{3}].next, VertexIndex{0});
  EXPECT_EQ(model.vertices[VertexIndex{7}].next, VertexIndex{4});
  EXPECT_EQ(model.vertices[VertexIndex{4}].previous, VertexIndex{7});
}

TEST(FromBlocks, area_and_centroid_leave_out_the_hole) {
  const Analysis analysis = plain_analysis(1e-3, 1);
  const Model model = model_from_blocks({{square_with_hole()}, {}, {}, {}, {}, {}}, analysis);
  const State state = start_state(model, profile_settings("legacy", analysis));
  const ElementState& block = state.elements[ElementIndex{0}];
  EXPECT_DOUBLE_EQ(block.moments.area, 15);
  EXPECT_DOUBLE_EQ(block.centroid.x, (16 * 2 - 1.5) / 15);
}

TEST(FromBlocks, scale_is_half_the_greater_side_of_the_scene) {
  const Model model = model_from_blocks({{rectangle({0, 0}, {10, 4})}, {}, {}, {}, {}, {}}, plain_analysis(1e-3, 1));
  EXPECT_DOUBLE_EQ(model.scale, 5);
}

TEST(FromBlocks, bolts_keep_their_ends_and_numbers) {
  Blocks blocks{{rectangle({0, 0}, {1, 1}), rectangle({2, 0}, {3, 1})}, {}, {}, {}, {}, {}};
  blocks.bolts = {{{{0.5, 0}, {2.5, 1.5}}, 0, 1, 1e6, 2e3, 50}};
  const Model model = model_from_blocks(blocks, plain_analysis(1e-3, 1));
  ASSERT_EQ(model.bolts.size(), 1U);
  const Bolt& bolt = model.bolts[0];
  EXPECT_EQ(bolt.first.element, ElementIndex{0});
  EXPECT_EQ(bolt.second.element, ElementIndex{1});
  EXPECT_EQ(bolt.second.start, (Point{2.5, 1.5}));
  EXPECT_EQ(bolt.strength, 2e3);
  EXPECT_DOUBLE_EQ(bolt.start_length(), 2.5);
  EXPECT_DOUBLE_EQ(bolt.force_at(2.5), 50);
  EXPECT_NEAR(bolt.force_at(2.501), 50 + 1e6 * 1e-3, 1e-6);  // longer: more tension
}

TEST(FromBlocks, strength_that_is_not_positive_is_no_limit) {
  Blocks blocks{{rectangle({0, 0}, {1, 1}), rectangle({2, 0}, {3, 1})}, {}, {}, {}, {}, {}};
  for (const double strength : {0.0, -1.0}) blocks.bolts.push_back({{{1, 0}, {2, 0}}, 0, 1, 1e6, strength, 0});
  for (const Bolt& bolt : model_from_blocks(blocks, plain_analysis(1e-3, 1)).bolts)
    EXPECT_TRUE(std::isinf(bolt.strength));
}

}  // namespace keyblock::from_blocks_test
