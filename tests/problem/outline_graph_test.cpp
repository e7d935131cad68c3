// Boundary lines as a graph: doubles count once, ends on lines divide them, faults have a place.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/lines/outline_graph.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/polygon.hpp"

namespace keyblock::outline_graph_test {
namespace {

std::vector<JointLine> lines_of(const std::vector<Segment>& segments) {
  std::vector<JointLine> lines;
  for (const Segment& segment : segments) lines.push_back({segment, 0, {}});
  return lines;
}

const std::vector<Segment> kSquare{{{0, 0}, {4, 0}}, {{4, 4}, {4, 0}}, {{4, 4}, {0, 4}}, {{0, 4}, {0, 0}}};

}  // namespace

TEST(OutlineGraph, a_square_is_one_loop) {
  const OutlineGraph graph(lines_of(kSquare));
  EXPECT_FALSE(graph.fault());
  ASSERT_EQ(graph.loops().size(), 1U);
  EXPECT_EQ(std::abs(area(graph.loops()[0])), 16);
}

TEST(OutlineGraph, lines_drawn_twice_count_once_however_they_are_divided) {
  std::vector<Segment> all = kSquare;
  all.insert(all.end(), {{{4, 0}, {1, 0}}, {{1, 0}, {0, 0}}, {{4, 0}, {4, 4}}, {{0, 4}, {0, 0}}, {{0, 4}, {2, 4}}});
  const OutlineGraph graph(lines_of(all));
  EXPECT_FALSE(graph.fault());
  ASSERT_EQ(graph.loops().size(), 1U);
  EXPECT_EQ(std::abs(area(graph.loops()[0])), 16);
  EXPECT_EQ(graph.pieces().size(), 6U);
}

TEST(OutlineGraph, an_open_end_is_found_with_the_nearest_other_one) {
  std::vector<Segment> all = kSquare;
  all[3].end = {0, 0.005};
  const auto fault = OutlineGraph(lines_of(all)).fault();
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->pieces, 1U);
  ASSERT_TRUE(fault->nearest);
  EXPECT_NEAR(distance(fault->at, *fault->nearest), 0.005, 1e-15);
}

TEST(OutlineGraph, a_branch_is_found_with_its_number_of_lines) {
  std::vector<Segment> all = kSquare;
  all.push_back({{2, 0}, {2, 4}});
  const auto fault = OutlineGraph(lines_of(all)).fault();
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->pieces, 3U);
}

}  // namespace keyblock::outline_graph_test
