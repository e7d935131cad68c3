// Shared edges show which edge the joint material of a vertex belongs to.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/shi/edge_convention.hpp"

#include <gtest/gtest.h>

namespace keyblock::formats::edge_convention_test {
namespace {

/// Squares left and right of x = 1, whose shared edge has material `on_start` at its first and `on_end` at its last
/// vertex, in the direction of each block.
std::vector<BlockPolygon> squares(int on_start, int on_end, double gap = 0) {
  return {{0, {{{0, 0}, 7}, {{1, 0}, on_start}, {{1, 1}, on_end}, {{0, 1}, 7}}, {}},
          {0, {{{1 + gap, 1}, on_start}, {{1 + gap, 0}, on_end}, {{2, 0}, 8}, {{2, 1}, 8}}, {}}};
}

}  // namespace

TEST(EdgeConvention, is_arriving_where_nothing_tells) {
  EXPECT_EQ(convention_of({}), EdgeConvention::arriving);
  EXPECT_EQ(convention_of(squares(3, 3)), EdgeConvention::arriving);
}

TEST(EdgeConvention, agreement_of_both_sides_decides) {
  std::vector<BlockPolygon> arriving = squares(1, 3);
  arriving[1].outer[0].joint_material = 2;
  EXPECT_EQ(convention_of(arriving), EdgeConvention::arriving);
  std::vector<BlockPolygon> leaving = squares(3, 1);
  leaving[1].outer[1].joint_material = 2;
  EXPECT_EQ(convention_of(leaving), EdgeConvention::leaving);
}

TEST(EdgeConvention, vertices_that_differ_in_the_sixth_decimal_are_one) {
  std::vector<BlockPolygon> leaving = squares(3, 1, 1e-6);
  leaving[1].outer[1].joint_material = 2;
  EXPECT_EQ(convention_of(leaving), EdgeConvention::leaving);
}

TEST(EdgeConvention, moving_materials_to_the_arriving_edge_turns_each_loop_by_one) {
  const auto moved = with_arriving_edges(squares(3, 1));
  EXPECT_EQ(moved[0].outer[2].joint_material, 3);
  EXPECT_EQ(moved[0].outer[0].joint_material, 7);
}

}  // namespace keyblock::formats::edge_convention_test
