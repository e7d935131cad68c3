// Lists the edges that meet in each node.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "cut/lines/arrangement.hpp"

namespace keyblock {

class Adjacency {
 public:
  explicit Adjacency(const Arrangement& arrangement) : start_(arrangement.nodes.size() + 1, 0) {
    for (const Edge& e : arrangement.edges) {
      ++start_[e.from + 1];
      ++start_[e.to + 1];
    }
    for (std::size_t i = 1; i < start_.size(); ++i) start_[i] += start_[i - 1];
    edges_.resize(start_.back());
    std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
    for (std::size_t i = 0; i < arrangement.edges.size(); ++i) {
      edges_[next[arrangement.edges[i].from]++] = static_cast<int>(i);
      edges_[next[arrangement.edges[i].to]++] = static_cast<int>(i);
    }
  }

  std::span<int> of(int node) { return {edges_.data() + start_[node], edges_.data() + start_[node + 1]}; }
  std::span<const int> of(int node) const { return {edges_.data() + start_[node], edges_.data() + start_[node + 1]}; }

 private:
  std::vector<std::size_t> start_;
  std::vector<int> edges_;
};

}  // namespace keyblock
