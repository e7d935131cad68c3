// Orders edges around nodes; see rotation.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/lines/rotation.hpp"

#include <algorithm>

#include "geometry/predicates.hpp"

namespace keyblock {
namespace {

/// Returns a direction as the segment between the exact positions of both nodes.
Segment by_coordinates(const Arrangement& a, int half_edge) {
  return {a.nodes[tail(a, half_edge)].position, a.nodes[head(a, half_edge)].position};
}

/// Returns true below the x axis; the x direction itself counts as above.
bool is_lower_half(const Segment& d) {
  return d.end.y < d.start.y || (d.end.y == d.start.y && d.end.x < d.start.x);
}

bool is_before(const Segment& a, const Segment& b) {
  if (is_lower_half(a) != is_lower_half(b)) return is_lower_half(b);
  return turn(a.start, a.end, b.start, b.end) > 0;
}

}  // namespace

Segment direction(const Arrangement& a, int half_edge) {
  const Edge& edge = a.edges[half_edge / 2];
  if (!edge.is_on_line) return by_coordinates(a, half_edge);
  const Segment& line = a.lines[edge.line];
  return half_edge % 2 == 0 ? line : Segment{line.end, line.start};
}

RotationSystem::RotationSystem(const Arrangement& a) : start_(a.nodes.size() + 1, 0), next_(2 * a.edges.size()) {
  const int count = static_cast<int>(2 * a.edges.size());
  for (int h = 0; h < count; ++h) ++start_[tail(a, h) + 1];
  for (std::size_t i = 1; i < start_.size(); ++i) start_[i] += start_[i - 1];
  order_.resize(start_.back());
  std::vector<std::size_t> free(start_.begin(), start_.end() - 1);
  for (int h = 0; h < count; ++h) order_[free[tail(a, h)]++] = h;
  for (std::size_t node = 0; node < a.nodes.size(); ++node) {
    const std::span<int> around(order_.data() + start_[node], order_.data() + start_[node + 1]);
    if (around.empty()) continue;
    std::sort(around.begin(), around.end(), [&](int x, int y) { return is_before(direction(a, x), direction(a, y)); });
    // Shi's programs take angles from rounded coordinates: an edge along x may get 0 or just below 360 degrees.
    std::rotate(around.begin(),
                std::min_element(around.begin(), around.end(),
                                 [&](int x, int y) { return is_before(by_coordinates(a, x), by_coordinates(a, y)); }),
                around.end());
    for (std::size_t k = 0; k < around.size(); ++k) {
      next_[twin(around[k])] = around[k == 0 ? around.size() - 1 : k - 1];
    }
  }
}

}  // namespace keyblock
