// Computes the minimum of many cones over the plane by a tree of points; see mesh_size.hpp. Library trees find the
// nearest point, not the least value: they were ten times as slow here.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/mesh/mesh_size.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "geometry/box.hpp"

namespace keyblock {
namespace {

constexpr std::size_t kPointsOfLeaf = 8;

double distance_to(const Box& box, Point p) {
  return std::hypot(std::max({box.low.x - p.x, 0.0, p.x - box.high.x}),
                    std::max({box.low.y - p.y, 0.0, p.y - box.high.y}));
}

}  // namespace

/// Points halved by their median across the longer side of their box, down to leaves (Friedman, Bentley & Finkel 1977).
class MeshSize::Halves {
 public:
  Halves(std::vector<RefinedPoint> points, double growth) : points_(std::move(points)), growth_(growth) {
    add(0, points_.size());
  }

  /// Returns the lesser of `side` and the sides that the points allow at p.
  double at(Point p, double side) const { return least_in(0, p, side); }

 private:
  struct Node {
    Box box;
    double least = std::numeric_limits<double>::infinity();  // least of the sides
    std::size_t first = 0, last = 0;                         // points of a leaf, one behind the last
    std::array<std::size_t, 2> halves{};                     // places in nodes_; 0: a leaf
  };

  std::size_t add(std::size_t first, std::size_t last) {
    const std::size_t at = nodes_.size();
    nodes_.push_back({{}, std::numeric_limits<double>::infinity(), first, last, {}});
    for (std::size_t i = first; i < last; ++i) {
      nodes_[at].box.add(points_[i].at);
      nodes_[at].least = std::min(nodes_[at].least, points_[i].side);
    }
    if (last - first <= kPointsOfLeaf) return at;
    const Point size = nodes_[at].box.size();
    const auto begin = points_.begin();
    const std::size_t middle = first + (last - first) / 2;
    std::nth_element(begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(middle),
                     begin + static_cast<std::ptrdiff_t>(last), [&](const RefinedPoint& a, const RefinedPoint& b) {
                       return size.x > size.y ? a.at.x < b.at.x : a.at.y < b.at.y;
                     });
    const std::size_t low = add(first, middle);
    const std::size_t high = add(middle, last);
    nodes_[at].halves = {low, high};
    return at;
  }

  double bound(std::size_t node, Point p) const {
    return nodes_[node].least + growth_ * distance_to(nodes_[node].box, p);
  }

  double least_in(std::size_t at, Point p, double side) const {
    const Node& node = nodes_[at];
    if (node.halves[0] == 0) {
      for (std::size_t i = node.first; i < node.last; ++i)
        side = std::min(side, points_[i].side + growth_ * distance(points_[i].at, p));
      return side;
    }
    std::array<std::pair<double, std::size_t>, 2> halves;
    for (std::size_t k = 0; k < 2; ++k) halves[k] = {bound(node.halves[k], p), node.halves[k]};
    if (halves[1].first < halves[0].first) std::swap(halves[0], halves[1]);
    for (const auto& [least, half] : halves)
      if (least < side) side = least_in(half, p, side);
    return side;
  }

  std::vector<RefinedPoint> points_;
  double growth_;
  std::vector<Node> nodes_;
};

MeshSize::MeshSize(double side, std::vector<RefinedPoint> refined, double growth)
    : side_(side),
      growth_(growth),
      least_(side),
      refined_(std::make_shared<const std::vector<RefinedPoint>>(std::move(refined))) {
  if (refined_->empty()) return;
  least_ = std::min(side, std::ranges::min(*refined_, {}, &RefinedPoint::side).side);
  halves_ = std::make_shared<const Halves>(*refined_, growth);
}

double MeshSize::at(Point p) const {
  return halves_ ? halves_->at(p, side_) : side_;
}

}  // namespace keyblock
