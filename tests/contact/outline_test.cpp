// Corners of convex blocks, and what is none.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/outline.hpp"

#include <gtest/gtest.h>

#include "tests/support/scenes.hpp"

namespace keyblock {
namespace {

Outline outline_of(const BlockLoop& loop, std::vector<BlockLoop> holes = {}) {
  Blocks blocks;
  blocks.blocks = {{0, loop, std::move(holes)}};
  return convex_outline(model_from_blocks(blocks, testing::plain_analysis(1, 1)), {0});
}

}  // namespace

TEST(Outline, a_vertex_on_a_straight_edge_is_no_corner) {
  const Outline corners = outline_of({{{0, 0}, 0}, {{1, 0}, 0}, {{1, 0.4}, 0}, {{1, 1}, 0}, {{0, 1}, 0}});
  EXPECT_EQ(corners, (Outline{{0}, {1}, {3}, {4}}));
}

TEST(Outline, a_block_with_a_notch_or_a_hole_has_none) {
  EXPECT_TRUE(outline_of({{{0, 0}, 0}, {{2, 0}, 0}, {{1, 0.5}, 0}, {{2, 2}, 0}, {{0, 2}, 0}}).empty());
  const BlockLoop square{{{0, 0}, 0}, {{3, 0}, 0}, {{3, 3}, 0}, {{0, 3}, 0}};
  const BlockLoop hole{{{1, 1}, 0}, {{1, 2}, 0}, {{2, 2}, 0}, {{2, 1}, 0}};
  EXPECT_TRUE(outline_of(square, {hole}).empty());
  EXPECT_EQ(outline_of(square).size(), 4U);
}

}  // namespace keyblock
