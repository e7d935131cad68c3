// Finds dangling pieces by peeling, bridges by depth-first search; see prune.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/lines/prune.hpp"

#include <algorithm>

#include "cut/lines/adjacency.hpp"

namespace keyblock {
namespace {

enum class Fate : char { kept, dangling, bridge };

void peel(const Arrangement& a, const Adjacency& around, std::vector<Fate>& fate) {
  std::vector<int> degree(a.nodes.size());
  std::vector<int> loose;
  for (std::size_t n = 0; n < a.nodes.size(); ++n) {
    degree[n] = static_cast<int>(around.of(static_cast<int>(n)).size());
    if (degree[n] == 1) loose.push_back(static_cast<int>(n));
  }
  while (!loose.empty()) {
    const int node = loose.back();
    loose.pop_back();
    for (const int e : around.of(node)) {
      if (fate[e] != Fate::kept) continue;
      fate[e] = Fate::dangling;
      const int beyond = a.edges[e].from == node ? a.edges[e].to : a.edges[e].from;
      if (--degree[beyond] == 1) loose.push_back(beyond);
    }
  }
}

/// Finds bridges by Tarjan's lowest reachable number, with the recursion unrolled. An edge down to a node is a bridge
/// if nothing leads back above that node.
class BridgeSearch {
 public:
  BridgeSearch(const Arrangement& a, const Adjacency& around, std::vector<Fate>& fate)
      : a_(a), around_(around), fate_(fate), number_(a.nodes.size(), 0), low_(a.nodes.size(), 0) {
    for (std::size_t n = 0; n < a.nodes.size(); ++n) {
      if (number_[n] == 0) search_from(static_cast<int>(n));
    }
  }

 private:
  struct Visit {
    int node;
    int edge_above;
    std::size_t next;
  };

  void enter(int node, int edge_above) {
    number_[node] = low_[node] = ++count_;
    stack_.push_back({node, edge_above, 0});
  }

  void search_from(int root) {
    enter(root, -1);
    while (!stack_.empty()) {
      Visit& top = stack_.back();
      const auto edges = around_.of(top.node);
      if (top.next == edges.size()) {
        leave();
        continue;
      }
      const int e = edges[top.next++];
      if (e == top.edge_above || fate_[e] == Fate::dangling) continue;
      const int beyond = a_.edges[e].from == top.node ? a_.edges[e].to : a_.edges[e].from;
      if (number_[beyond] == 0) {
        enter(beyond, e);
      } else {
        low_[top.node] = std::min(low_[top.node], number_[beyond]);
      }
    }
  }

  void leave() {
    const Visit done = stack_.back();
    stack_.pop_back();
    if (stack_.empty()) return;
    const int above = stack_.back().node;
    if (low_[done.node] > number_[above]) fate_[done.edge_above] = Fate::bridge;
    low_[above] = std::min(low_[above], low_[done.node]);
  }

  const Arrangement& a_;
  const Adjacency& around_;
  std::vector<Fate>& fate_;
  std::vector<int> number_;
  std::vector<int> low_;
  std::vector<Visit> stack_;
  int count_ = 0;
};

}  // namespace

Pruning prune(const Arrangement& arrangement) {
  const Adjacency around(arrangement);
  std::vector<Fate> fate(arrangement.edges.size(), Fate::kept);
  peel(arrangement, around, fate);
  BridgeSearch(arrangement, around, fate);
  Pruning result;
  for (std::size_t e = 0; e < fate.size(); ++e) {
    auto& list = fate[e] == Fate::kept ? result.kept : fate[e] == Fate::dangling ? result.dangling : result.bridges;
    list.push_back(arrangement.edges[e]);
  }
  return result;
}

}  // namespace keyblock
