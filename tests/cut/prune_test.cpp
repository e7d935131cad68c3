// An edge stays if and only if it lies on a closed chain.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/lines/prune.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "base/union_find.hpp"
#include "tests/cut/arrangements.hpp"

namespace keyblock::prune_test {
namespace {

using Ends = std::vector<std::pair<int, int>>;

Arrangement graph(int nodes, const Ends& ends) {
  return arrangement_of(std::vector<Point>(static_cast<std::size_t>(nodes)), ends);
}

/// Returns true if the ends of edge `e` are connected without it.
bool is_on_closed_chain(const Arrangement& a, std::size_t e) {
  UnionFind parts(a.nodes.size());
  for (std::size_t i = 0; i < a.edges.size(); ++i)
    if (i != e) parts.unite(a.edges[i].from, a.edges[i].to);
  return parts.find(a.edges[e].from) == parts.find(a.edges[e].to);
}

}  // namespace

TEST(Prune, trees_dangle_and_loops_stay) {
  const Pruning pruned = prune(graph(7, {{0, 1}, {1, 2}, {2, 0}, {2, 3}, {3, 4}, {5, 6}}));
  EXPECT_EQ(ends_of(pruned.kept), (Ends{{0, 1}, {1, 2}, {2, 0}}));
  EXPECT_EQ(ends_of(pruned.dangling), (Ends{{2, 3}, {3, 4}, {5, 6}}));
  EXPECT_TRUE(pruned.bridges.empty());
}

TEST(Prune, what_joins_two_loops_is_a_bridge) {
  const Pruning pruned = prune(graph(7, {{0, 1}, {1, 2}, {2, 0}, {2, 3}, {3, 4}, {4, 5}, {5, 6}, {6, 4}}));
  EXPECT_EQ(ends_of(pruned.bridges), (Ends{{2, 3}, {3, 4}}));
  EXPECT_EQ(pruned.kept.size(), 6U);
  EXPECT_TRUE(pruned.dangling.empty());
}

TEST(Prune, two_loops_through_one_node_need_no_bridge) {
  EXPECT_EQ(prune(graph(5, {{0, 1}, {1, 2}, {2, 0}, {2, 3}, {3, 4}, {4, 2}})).kept.size(), 6U);
}

TEST(Prune, two_edges_between_the_same_nodes_are_a_loop) {
  EXPECT_EQ(prune(graph(2, {{0, 1}, {1, 0}})).kept.size(), 2U);
}

TEST(Prune, edges_that_stay_are_those_whose_ends_hang_together_without_them) {
  std::mt19937 random(5);
  int kept = 0;
  int removed = 0;
  for (int trial = 0; trial < 50; ++trial) {
    std::uniform_int_distribution<int> node(0, 19);
    Ends ends;
    while (ends.size() < 22) {
      const int from = node(random);
      const int to = node(random);
      if (from != to && std::ranges::find(ends, std::pair(from, to)) == ends.end()) ends.push_back({from, to});
    }
    const Arrangement a = graph(20, ends);
    Ends expected;
    for (std::size_t e = 0; e < ends.size(); ++e)
      if (is_on_closed_chain(a, e)) expected.push_back(ends[e]);
    const Pruning pruned = prune(a);
    EXPECT_EQ(ends_of(pruned.kept), expected) << "trial " << trial;
    EXPECT_EQ(pruned.kept.size() + pruned.dangling.size() + pruned.bridges.size(), ends.size());
    kept += static_cast<int>(expected.size());
    removed += static_cast<int>(ends.size() - expected.size());
  }
  EXPECT_GT(kept, 100);
  EXPECT_GT(removed, 100);
}

}  // namespace keyblock::prune_test
