// Edges about a node counter-clockwise, distinguished by their lines if coordinates cannot.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/lines/rotation.hpp"

#include <gtest/gtest.h>

#include "tests/cut/arrangements.hpp"

namespace keyblock::rotation_test {
namespace {

std::vector<int> heads_about(const Arrangement& a, int node) {
  std::vector<int> heads;
  const RotationSystem rotation(a);
  for (const int h : rotation.leaving(node)) heads.push_back(head(a, h));
  return heads;
}

}  // namespace

TEST(RotationSystem, edges_leave_a_node_counter_clockwise_from_the_x_direction) {
  const std::vector<Point> nodes{{0, 0}, {0, -1}, {1, 0}, {-1, 0}, {1, 1}, {-1, -1}, {0, 1}, {1, -1}};
  const Arrangement star = arrangement_of(nodes, {{1, 0}, {0, 2}, {0, 3}, {4, 0}, {5, 0}, {0, 6}, {0, 7}});
  EXPECT_EQ(heads_about(star, 0), (std::vector<int>{2, 4, 6, 3, 5, 1, 7}));
  EXPECT_EQ(heads_about(star, 5), (std::vector<int>{0}));
}

TEST(RotationSystem, the_next_half_edge_keeps_the_face_on_the_left) {
  const Arrangement square = arrangement_of({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 2}});
  const RotationSystem rotation(square);
  EXPECT_EQ(rotation.next(0), 2) << "0 → 1 goes on to 1 → 2";
  EXPECT_EQ(rotation.next(2), 9) << "1 → 2 turns back along the diagonal 2 → 0";
  EXPECT_EQ(rotation.next(9), 0);
  EXPECT_EQ(rotation.next(4), 6) << "2 → 3 goes on to 3 → 0";
  EXPECT_EQ(rotation.next(6), 8) << "3 → 0 turns into the diagonal 0 → 2";
  EXPECT_EQ(rotation.next(twin(0)), twin(6)) << "outside, in the other direction";
}

TEST(RotationSystem, twins_have_head_and_tail_exchanged) {
  const Arrangement one = arrangement_of({{0, 0}, {1, 0}}, {{1, 0}});
  EXPECT_EQ(tail(one, 0), 1);
  EXPECT_EQ(head(one, 0), 0);
  EXPECT_EQ(tail(one, twin(0)), 0);
}

// Two edges whose far nodes were rounded to one point: the lines they lie on decide their order.
TEST(RotationSystem, edges_on_their_lines_are_ordered_by_the_lines) {
  for (const bool is_upper_first : {true, false}) {
    Arrangement a = arrangement_of({{0, 0}, {1, 1}, {1, 1}, {-1, 0}}, {{0, 1}, {0, 2}, {0, 3}});
    a.lines[0] = {{-3, -3}, {3, is_upper_first ? 3.001 : 2.999}};
    a.lines[1] = {{-3, -3}, {3, 3}};
    a.edges[2].is_on_line = false;
    EXPECT_EQ(heads_about(a, 0), (is_upper_first ? std::vector<int>{2, 1, 3} : std::vector<int>{1, 2, 3}));
  }
}

}  // namespace keyblock::rotation_test
