// Pieces that pass a node too near go through it; pieces that cross after nodes have moved get a node.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/lines/planarize.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/segment.hpp"
#include "tests/cut/arrangements.hpp"

namespace keyblock::planarize_test {
namespace {

using Ends = std::vector<std::pair<int, int>>;

/// Nodes nearer than a tenth are passed through.
CutTolerances a_tenth() {
  CutTolerances t;
  t.near_pass = 0.1;
  t.merge = 0.125;
  t.round_off = 1e-9;
  return t;
}

/// A piece 0 → 1 from (0, 0) to (10, 0), and an upright piece 2 → 3 that stands at `gap` above its middle.
Arrangement passing(double gap) {
  return arrangement_of({{0, 0}, {10, 0}, {5, gap}, {5, 5}}, {{0, 1}, {2, 3}});
}

Ends sorted(Ends ends) {
  for (auto& [from, to] : ends)
    if (from > to) std::swap(from, to);
  std::ranges::sort(ends);
  return ends;
}

}  // namespace

TEST(Planarize, a_piece_is_led_through_a_node_beside_it) {
  const Planarized p = planarize(passing(0.09), 0, a_tenth());
  EXPECT_EQ(sorted(ends_of(p.arrangement.edges)), (Ends{{0, 2}, {1, 2}, {2, 3}}));
  ASSERT_EQ(p.detours.size(), 1U);
  EXPECT_EQ(p.detours[0].line, 0);
  EXPECT_EQ(p.detours[0].node, 2);
  EXPECT_EQ(p.detours[0].from, (Point{5, 0}));
  for (const Edge& e : p.arrangement.edges) EXPECT_EQ(e.is_on_line, e.line == 1) << "the detour leaves its line";
}

TEST(Planarize, a_node_farther_than_the_tolerance_is_passed_by) {
  const Planarized p = planarize(passing(0.11), 0, a_tenth());
  EXPECT_TRUE(p.detours.empty());
  EXPECT_EQ(p.arrangement.edges.size(), 2U);
}

// Nearly all nodes lie beside one another. Following each part of a piece by itself would take 2^n parts.
TEST(Planarize, a_piece_among_many_nodes_beside_one_another_comes_to_an_end) {
  std::vector<Point> nodes{{0, 0}, {10, 0}};
  std::vector<std::pair<int, int>> pieces{{0, 1}};
  for (int i = 0; i < 60; ++i) {
    nodes.push_back({5 + 0.05 * std::sin(7.0 * i), 0.09 * std::cos(11.0 * i)});
    nodes.push_back({5 + 0.05 * std::sin(13.0 * i), 0.09 * std::cos(5.0 * i)});
    pieces.push_back({2 * i + 2, 2 * i + 3});
  }
  const Planarized p = planarize(arrangement_of(nodes, pieces), 0, a_tenth());
  EXPECT_FALSE(p.is_settled) << "each iteration makes more";
}

TEST(Planarize, boundary_pieces_make_detours_within_round_off_only) {
  EXPECT_TRUE(planarize(passing(0.09), 1, a_tenth()).detours.empty());
  EXPECT_EQ(planarize(passing(5e-10), 1, a_tenth()).detours.size(), 1U);
}

TEST(Planarize, nodes_beside_one_piece_are_passed_in_their_order_along_it) {
  const Arrangement a =
      arrangement_of({{0, 0}, {10, 0}, {7, 0.05}, {7, 5}, {3, -0.05}, {3, -5}}, {{1, 0}, {2, 3}, {4, 5}});
  const Planarized p = planarize(a, 0, a_tenth());
  EXPECT_EQ(sorted(ends_of(p.arrangement.edges)), (Ends{{0, 4}, {1, 2}, {2, 3}, {2, 4}, {4, 5}}));
}

TEST(Planarize, a_detour_along_a_piece_that_is_there_already_is_not_doubled) {
  Arrangement a = arrangement_of({{0, 0}, {10, 0}, {5, 0.05}}, {{0, 2}, {2, 1}, {0, 1}});
  const Planarized p = planarize(a, 0, a_tenth());
  EXPECT_EQ(sorted(ends_of(p.arrangement.edges)), (Ends{{0, 2}, {1, 2}}));
  for (const Edge& e : p.arrangement.edges) EXPECT_LT(e.line, 2) << "the lower-numbered line keeps it";
}

TEST(Planarize, pieces_off_their_lines_that_cross_get_a_node) {
  Arrangement a = arrangement_of({{0, 0}, {4, 4}, {0, 4}, {4, 0}}, {{0, 1}, {2, 3}});
  a.edges[0].is_on_line = false;
  const Planarized p = planarize(a, 0, a_tenth());
  EXPECT_EQ(p.crossings, 1);
  ASSERT_EQ(p.arrangement.nodes.size(), 5U);
  EXPECT_EQ(p.arrangement.nodes[4].position, (Point{2, 2}));
  EXPECT_EQ(sorted(ends_of(p.arrangement.edges)), (Ends{{0, 4}, {1, 4}, {2, 4}, {3, 4}}));
}

TEST(Planarize, what_is_plane_already_is_left_as_it_is) {
  const Arrangement square = arrangement_of({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}});
  const Planarized p = planarize(square, 0, a_tenth());
  EXPECT_EQ(ends_of(p.arrangement.edges), ends_of(square.edges));
  EXPECT_EQ(p.crossings, 0);
}

}  // namespace keyblock::planarize_test
