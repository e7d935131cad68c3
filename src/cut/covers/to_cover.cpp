// Turns elements into slots and puts points into elements; see to_cover.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/covers/to_cover.hpp"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "geometry/box.hpp"
#include "geometry/polygon.hpp"
#include "geometry/segment.hpp"

namespace keyblock {
namespace {

bool holds(const std::vector<std::vector<Point>>& loops, Point p) {
  if (side(loops[0], p) == Side::outside) return false;
  return std::none_of(loops.begin() + 1, loops.end(), [&](const auto& hole) { return side(hole, p) == Side::inside; });
}

/// Calls `visit` with each edge of closed loops.
template <class Visit>
void visit_edges(const std::vector<std::vector<Point>>& loops, Visit visit) {
  for (const std::vector<Point>& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) visit(Segment{loop[i], loop[i + 1 == loop.size() ? 0 : i + 1]});
  }
}

double distance_to_edges(const std::vector<std::vector<Point>>& loops, Point p) {
  double nearest = std::numeric_limits<double>::max();
  visit_edges(loops, [&](const Segment& edge) { nearest = std::min(nearest, distance(edge, p)); });
  return nearest;
}

/// Orders the corners of an element and its holes in one chain.
class Chaining {
 public:
  Chaining(const Manifold& manifold, const ManifoldElement& element)
      : manifold_(manifold), loops_(manifold.polygon(element)) {
    for (int i = 0; i < element.outer.size; ++i) chain_.push_back(element.outer.first + i);
    std::vector<SlotRange> holes(manifold.holes_of(element).begin(), manifold.holes_of(element).end());
    for (const SlotRange& hole : holes) insert(hole);
  }

  const std::vector<int>& chain() const { return chain_; }

 private:
  struct Bridge {
    double length = 0;
    int at = 0;      // place in the chain
    int corner = 0;  // corner of the hole
  };

  Point position(int corner) const { return manifold_.corners[corner].position; }

  void insert(const SlotRange& hole) {
    const Bridge bridge = shortest_bridge(hole);
    std::vector<int> detour;
    for (int i = 0; i <= hole.size; ++i) detour.push_back(hole.first + (bridge.corner - hole.first + i) % hole.size);
    detour.push_back(chain_[bridge.at]);
    chain_.insert(chain_.begin() + bridge.at + 1, detour.begin(), detour.end());
  }

  /// Returns the shortest bridge that crosses no edge of the element.
  Bridge shortest_bridge(const SlotRange& hole) const {
    std::vector<Bridge> bridges;
    for (int at = 0; at < static_cast<int>(chain_.size()); ++at) {
      for (int corner = hole.first; corner < hole.first + hole.size; ++corner)
        bridges.push_back({distance(position(chain_[at]), position(corner)), at, corner});
    }
    std::stable_sort(bridges.begin(), bridges.end(),
                     [](const Bridge& a, const Bridge& b) { return a.length < b.length; });
    const auto is_free = std::find_if(bridges.begin(), bridges.end(), [&](const Bridge& b) {
      const Segment way{position(chain_[b.at]), position(b.corner)};
      bool is_crossed = false;
      visit_edges(loops_, [&](const Segment& edge) {
        const bool is_end =
            edge.start == way.start || edge.end == way.start || edge.start == way.end || edge.end == way.end;
        is_crossed |= !is_end && meeting(way, edge) != Meeting::none;
      });
      return !is_crossed;
    });
    return is_free == bridges.end() ? bridges.front() : *is_free;
  }

  const Manifold& manifold_;
  std::vector<std::vector<Point>> loops_;
  std::vector<int> chain_;
};

std::vector<CoverPoint> in_elements(const Manifold& manifold, const std::vector<BlockPoint>& points) {
  std::vector<CoverPoint> result;
  for (const BlockPoint& point : points)
    result.push_back({point.position, element_at(manifold, point.block, point.position), point.place});
  return result;
}

}  // namespace

int element_at(const Manifold& manifold, int body, Point p) {
  int nearest = -1;
  double least = std::numeric_limits<double>::max();
  for (std::size_t e = 0; e < manifold.elements.size(); ++e) {
    const ManifoldElement& element = manifold.elements[e];
    if (element.body != body) continue;
    Box box;
    for (const ElementCorner& corner : manifold.loop(element.outer)) box.add(corner.position);
    const Point beside{std::max({box.low.x - p.x, p.x - box.high.x, 0.0}),
                       std::max({box.low.y - p.y, p.y - box.high.y, 0.0})};
    if (length(beside) >= least) continue;
    const auto loops = manifold.polygon(element);
    if (holds(loops, p)) return static_cast<int>(e);
    const double gap = distance_to_edges(loops, p);
    if (gap >= least) continue;
    least = gap;
    nearest = static_cast<int>(e);
  }
  return nearest;
}

ElementPoints points_in_elements(const Manifold& manifold, const Blocks& blocks) {
  return {in_elements(manifold, blocks.fixed_points), in_elements(manifold, blocks.loading_points),
          in_elements(manifold, blocks.measured_points)};
}

Cover to_cover(const Manifold& manifold, const Blocks& blocks) {
  Cover cover;
  cover.place = blocks.place;
  std::vector<int> slot_of_corner(manifold.corners.size(), -1);
  for (const ManifoldElement& element : manifold.elements) {
    const Chaining chaining(manifold, element);
    const std::vector<int>& chain = chaining.chain();
    const int first = static_cast<int>(cover.vertices.size());
    for (std::size_t i = 0; i < chain.size(); ++i) {
      if (slot_of_corner[chain[i]] < 0) slot_of_corner[chain[i]] = first + static_cast<int>(i);
      cover.vertices.push_back(manifold.corners[chain[i]].position);
    }
    cover.vertices.push_back(manifold.corners[chain.front()].position);
    cover.elements.push_back(
        {{first, static_cast<int>(chain.size())}, manifold.body_materials[element.body], element.covers});
  }
  for (const PhysicalCover& physical : manifold.covers) cover.nodes.push_back(manifold.mesh.nodes[physical.node]);
  for (const SlotRange& loop : manifold.boundary_loops) {
    const int first = static_cast<int>(cover.loop_vertices.size());
    for (int k = loop.first; k < loop.first + loop.size; ++k) {
      const int corner = manifold.boundary_edges[k].corner;
      cover.loop_vertices.push_back({slot_of_corner[corner], manifold.corners[corner].joint_material});
    }
    cover.loop_vertices.push_back(cover.loop_vertices[first]);
    cover.loops.push_back({first, loop.size});
  }
  ElementPoints points = points_in_elements(manifold, blocks);
  cover.fixed_points = std::move(points.fixed);
  cover.loading_points = std::move(points.loading);
  cover.measured_points = std::move(points.measured);
  return cover;
}

}  // namespace keyblock
