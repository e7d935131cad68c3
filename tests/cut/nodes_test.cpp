// Crossings that become one node, and its place, under both ways of merging.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/lines/nodes.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/cut/drawings.hpp"

namespace keyblock::nodes_test {
namespace {

/// Merging distance 0.1, round-off 1e-9.
CutTolerances a_tenth() {
  CutTolerances t;
  t.merge = 0.1;
  t.round_off = 1e-9;
  t.reach_ratio = 1e-7;
  return t;
}

NodeTable nodes_of(const std::vector<Segment>& lines, NodeMerging merging, std::size_t boundary_count = 0,
                   const CutTolerances& tolerances = a_tenth()) {
  return make_nodes(lines, boundary_count, find_crossings(lines, tolerances), tolerances, merging);
}

/// An axis crossed by upright lines at the given places, in the order given.
std::vector<Segment> comb(const std::vector<double>& places) {
  std::vector<Segment> lines{{{-5, 0}, {5, 0}}};
  for (double x : places) lines.push_back({{x, -1}, {x, 1}});
  return lines;
}

std::vector<double> places_of(const NodeTable& table) {
  std::vector<double> places;
  for (const Node& node : table.arrangement.nodes) places.push_back(node.position.x);
  return places;
}

constexpr NodeMerging kBoth[] = {NodeMerging::nearest_first, NodeMerging::in_order_found};

}  // namespace

TEST(Nodes, crossings_that_are_one_point_are_one_exact_node_however_they_merge) {
  const std::vector<Segment> lines{{{0, 0}, {3, 1}}, {{0, 1}, {3, 0}}, {{1.5, -1}, {1.5, 2}}};
  for (NodeMerging merging : kBoth) {
    const NodeTable table = nodes_of(lines, merging);
    ASSERT_EQ(table.arrangement.nodes.size(), 1U);
    EXPECT_TRUE(table.arrangement.nodes[0].is_exact);
    EXPECT_TRUE(table.moves.empty());
  }
}

TEST(Nodes, apart_by_more_than_the_merging_distance_nothing_merges) {
  for (NodeMerging merging : kBoth) {
    const NodeTable table = nodes_of(comb({0, 0.11, 0.22}), merging);
    EXPECT_EQ(places_of(table), (std::vector<double>{0, 0.11, 0.22}));
    ASSERT_EQ(table.arrangement.edges.size(), 2U);
    EXPECT_EQ(table.arrangement.edges[0].from, 0);
    EXPECT_EQ(table.arrangement.edges[0].to, 1);
    EXPECT_TRUE(table.arrangement.edges[0].is_on_line);
  }
}

TEST(Nodes, two_near_crossings_are_one_node_and_the_move_is_told) {
  for (NodeMerging merging : kBoth) {
    const NodeTable table = nodes_of(comb({0, 3, 0.04}), merging);
    EXPECT_EQ(places_of(table), (std::vector<double>{0, 3}));
    EXPECT_FALSE(table.arrangement.nodes[0].is_exact);
    EXPECT_TRUE(table.arrangement.nodes[1].is_exact);
    ASSERT_EQ(table.moves.size(), 1U);
    EXPECT_EQ(table.moves[0].node, 0);
    EXPECT_EQ(table.moves[0].line, 3);
    EXPECT_EQ(table.moves[0].from, (Point{0.04, 0}));
  }
}

// Three in a row, the middle one nearer to the right one. In the order found it joins the left one, which came first;
// by nearness the right one, and the left one stays apart.
TEST(Nodes, nearest_first_joins_the_nearer_pair_and_in_order_found_the_earlier_node) {
  const std::vector<double> row{0, 0.09, 0.15};
  EXPECT_EQ(places_of(nodes_of(comb(row), NodeMerging::in_order_found)), (std::vector<double>{0, 0.15}));
  EXPECT_EQ(places_of(nodes_of(comb(row), NodeMerging::nearest_first)), (std::vector<double>{0, 0.09}));
}

// The nodes of Shi's programs depend on the order of the lines, Keyblock's need not: from right to left it joins the
// other way.
TEST(Nodes, only_in_order_found_depends_on_the_order_of_lines) {
  const auto groups = [](std::vector<double> row, NodeMerging merging) {
    std::vector<bool> left_alone;
    for (const Node& node : nodes_of(comb(row), merging).arrangement.nodes)
      if (node.is_exact) left_alone.push_back(node.position.x == 0);
    return left_alone;
  };
  EXPECT_EQ(groups({0, 0.09, 0.15}, NodeMerging::nearest_first), (std::vector<bool>{true}));
  EXPECT_EQ(groups({0.15, 0.09, 0}, NodeMerging::nearest_first), (std::vector<bool>{true}));
  EXPECT_EQ(groups({0, 0.09, 0.15}, NodeMerging::in_order_found), (std::vector<bool>{false}));
  EXPECT_EQ(groups({0.15, 0.09, 0}, NodeMerging::in_order_found), (std::vector<bool>{true}));
}

// A crossing joins the node that came first, which does not move: the chain 0, 0.08, 0.16 ends after two.
TEST(Nodes, no_node_grows_beyond_the_merging_distance) {
  for (NodeMerging merging : kBoth) {
    const NodeTable table = nodes_of(comb({0, 0.08, 0.16, 0.24}), merging);
    EXPECT_EQ(table.arrangement.nodes.size(), 2U);
    for (const NodeMove& move : table.moves)
      EXPECT_LE(distance(move.from, table.arrangement.nodes[move.node].position), 0.1);
  }
}

TEST(Nodes, crossings_of_boundary_lines_with_one_another_stay_apart) {
  for (NodeMerging merging : kBoth) {
    const std::vector<Segment> lines = comb({0, 0.04, 3, 3.04});
    EXPECT_EQ(places_of(nodes_of(lines, merging, 3)), (std::vector<double>{0, 0.04, 3}));
    EXPECT_EQ(places_of(nodes_of(lines, merging, 0)), (std::vector<double>{0, 3}));
  }
}

// Shi's programs look for crossings with boundary lines first (legacy-formats 3.6).
TEST(Nodes, crossings_with_boundary_lines_are_numbered_first) {
  const std::vector<Segment> lines{{{-5, 0}, {5, 0}}, {{0, -1}, {0, 3}}, {{-1, 2}, {4, 2}}, {{3, -1}, {3, 3}}};
  for (NodeMerging merging : kBoth) {
    const NodeTable with_boundary = nodes_of(lines, merging, 1);
    const std::vector<Point> found{{0, 0}, {3, 0}, {0, 2}, {3, 2}};
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_EQ(with_boundary.arrangement.nodes[i].position, found[i]);
    EXPECT_EQ(nodes_of(lines, merging, 0).arrangement.nodes[1].position, (Point{0, 2}));
  }
}

TEST(Nodes, a_piece_shared_by_two_lines_belongs_to_the_lower_numbered) {
  const std::vector<Segment> lines{{{0, 0}, {4, 0}}, {{3, 0}, {9, 0}}, {{0, 0}, {0, 1}}, {{9, 0}, {9, 1}}};
  for (NodeMerging merging : kBoth) {
    const NodeTable table = nodes_of(lines, merging);
    int from_three_to_four = 0;
    for (const Edge& e : table.arrangement.edges) {
      const double middle = (table.arrangement.nodes[e.from].position.x + table.arrangement.nodes[e.to].position.x) / 2;
      if (middle != 3.5) continue;
      ++from_three_to_four;
      EXPECT_EQ(e.line, 0);
    }
    EXPECT_EQ(from_three_to_four, 1);
  }
}

}  // namespace keyblock::nodes_test
