// Orders the edges around each node, the only geometry that tracing faces needs. Half-edge 2e runs along edge e from
// `from` to `to`, half-edge 2e + 1 back.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "cut/lines/arrangement.hpp"

namespace keyblock {

constexpr int twin(int half_edge) {
  return half_edge ^ 1;
}
inline int tail(const Arrangement& a, int half_edge) {
  return half_edge % 2 == 0 ? a.edges[half_edge / 2].from : a.edges[half_edge / 2].to;
}
inline int head(const Arrangement& a, int half_edge) {
  return tail(a, twin(half_edge));
}

/// Returns a segment from one point to another in the exact direction of a half-edge.
Segment direction(const Arrangement& a, int half_edge);

class RotationSystem {
 public:
  explicit RotationSystem(const Arrangement& arrangement);

  /// Returns the half-edges leaving a node, counter-clockwise from the x direction.
  std::span<const int> leaving(int node) const {
    return {order_.data() + start_[node], order_.data() + start_[node + 1]};
  }

  /// Returns the half-edge that continues the walk with the same face on the left.
  int next(int half_edge) const { return next_[half_edge]; }

 private:
  std::vector<std::size_t> start_;
  std::vector<int> order_;
  std::vector<int> next_;
};

}  // namespace keyblock
