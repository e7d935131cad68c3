// Visits points along the edges; see held_edges.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "terms/held_edges.hpp"

#include <algorithm>
#include <map>

#include "geometry/box.hpp"
#include "geometry/quadrature.hpp"
#include "geometry/segment.hpp"
#include "terms/stabilisation.hpp"

namespace keyblock {
namespace {

constexpr double kSamePlace = 1e-9;  // per extent: edges of two scenes are cut from the same lines

// Least length of edges in a mean, per size of a triangle.
constexpr double kStretch = 0.6;

/// Returns true if a boundary edge runs through its triangle, not along a side of it.
bool cuts_triangle(const Manifold& manifold, const ElementSide& side, double near) {
  const auto corners = manifold.triangle(manifold.elements[static_cast<std::size_t>(side.element)]);
  for (std::size_t i = 0; i < 3; ++i) {
    const Segment of{corners[i], corners[(i + 1) % 3]};
    if (distance(of, side.edge.start) <= near && distance(of, side.edge.end) <= near) return false;
  }
  return true;
}

/// Removes edges of one body that follow one another on a straight line from `sides`, and returns them in their order.
std::vector<ElementSide> take_straight(const Manifold& manifold, std::vector<ElementSide>& sides, double near) {
  std::vector<ElementSide> straight{sides.back()};
  sides.pop_back();
  const auto body = [&](const ElementSide& side) {
    return manifold.elements[static_cast<std::size_t>(side.element)].body;
  };
  const Point n = straight.front().normal();
  for (bool found = true; found;) {
    found = false;
    for (std::size_t i = 0; i < sides.size() && !found; ++i) {
      const bool follows = distance(straight.back().edge.end, sides[i].edge.start) <= near;
      const bool leads = distance(sides[i].edge.end, straight.front().edge.start) <= near;
      if (!follows && !leads) continue;
      if (body(sides[i]) != body(straight.front()) || length(sides[i].normal() - n) > kSamePlace) continue;
      straight.insert(follows ? straight.end() : straight.begin(), sides[i]);
      sides.erase(sides.begin() + static_cast<std::ptrdiff_t>(i));
      found = true;
    }
  }
  return straight;
}

}  // namespace

Eigen::Matrix2d held_projector(Held held, Point normal) {
  const Eigen::Vector2d n(normal.x, normal.y);
  switch (held) {
    case Held::both:
      return Eigen::Matrix2d::Identity();
    case Held::normal:
      return n * n.transpose();
    case Held::x:
      return Eigen::Vector2d::UnitX() * Eigen::RowVector2d::UnitX();
    case Held::y:
      return Eigen::Vector2d::UnitY() * Eigen::RowVector2d::UnitY();
  }
  return Eigen::Matrix2d::Zero();
}

Eigen::Vector2d HeldEdges::HeldPoint::displacement(const Eigen::VectorXd& d) const {
  Eigen::Vector2d u = Eigen::Vector2d::Zero();
  for (std::size_t a = 0; a < functions.size(); ++a)
    u += values(static_cast<Eigen::Index>(a)) * d.segment<2>(2 * functions[a]);
  return u;
}

struct HeldEdges::Sides {
  const Continuum& continuum;
  const CoverBasis& basis;
  const PrescribedDisplacement& prescribed;
  std::size_t part;

  ElementShape shape(const ElementSide& side) const { return basis.shape(side.element); }
  double stiffness(const ElementSide& side) const {
    return kHeldSprings * continuum.modulus(side.element)(0, 0) / shape(side).frame.size;
  }
};

HeldEdges::HeldEdges(const Continuum& continuum, const CoverBasis& basis) : parts_(continuum.prescribed.size()) {
  Box box;
  for (const ElementCorner& corner : continuum.manifold.corners) box.add(corner.position);
  near_ = kSamePlace * length(box.size());
  for (std::size_t part = 0; part < parts_; ++part) {
    const Sides sides{continuum, basis, continuum.prescribed[part], part};
    std::vector<ElementSide> cuts;
    for (const ElementSide& side : sides_along(continuum.manifold, sides.prescribed.along)) {
      if (basis.functions() == CoverFunctions::constant && cuts_triangle(continuum.manifold, side, near_))
        cuts.push_back(side);
      else
        add_points(sides, side);
    }
    while (!cuts.empty()) add_means(sides, take_straight(continuum.manifold, cuts, near_));
  }
}

void HeldEdges::add_points(const Sides& sides, const ElementSide& side) {
  const ElementShape shape = sides.shape(side);
  const Point n = side.normal();
  const double stiffness = sides.stiffness(side);
  const double all = length(side.edge.end - side.edge.start);
  for (const GaussPoint& g : gauss_rule(shape.degree + 2)) {
    const Point x = point_at(side.edge, g.at);
    const Point value = sides.prescribed.value(x, n);
    HeldPoint& held = points_.emplace_back();
    held.part = sides.part;
    held.at = x;
    held.functions.assign(shape.functions.begin(), shape.functions.end());
    held.values = shape.values(x);
    held.stiffness = stiffness * all * g.weight;
    held.projector = held_projector(sides.prescribed.held, n);
    held.to = {value.x, value.y};
  }
}

// The spring of a mean is the sum over its parts: ∫ k ψ.
void HeldEdges::add_means(const Sides& sides, std::span<const ElementSide> straight) {
  const Point start = straight.front().edge.start, n = straight.front().normal();
  const Point along = straight.back().edge.end - start;
  const double all = length(along);
  std::vector<double> ends{0};  // of stretches
  double held = 0;              // of the present stretch
  for (const ElementSide& side : straight) {
    const double to = dot(side.edge.end - start, along) / all;
    held += length(side.edge.end - side.edge.start);
    if (held < kStretch * sides.shape(side).frame.size) continue;
    ends.push_back(to);
    held = 0;
  }
  if (ends.size() == 1)
    ends.push_back(all);
  else
    ends.back() = all;
  std::vector<std::map<int, double>> values(ends.size());
  std::vector<double> weights(ends.size()), stiffness(ends.size());
  std::vector<Eigen::Vector2d> to(ends.size(), Eigen::Vector2d::Zero());
  std::vector<Point> at(ends.size());  // where the force of a mean acts
  const auto add = [&](std::size_t hat, double weight, const ElementSide& side, const ElementShape& shape, Point x) {
    const Eigen::RowVectorXd of_functions = shape.values(x);
    const Point value = sides.prescribed.value(x, n);
    for (std::size_t a = 0; a < shape.functions.size(); ++a)
      values[hat][shape.functions[a]] += weight * of_functions(static_cast<Eigen::Index>(a));
    weights[hat] += weight;
    stiffness[hat] += weight * sides.stiffness(side);
    to[hat] += weight * Eigen::Vector2d(value.x, value.y);
    at[hat] = at[hat] + weight * x;
  };
  for (const ElementSide& side : straight) {
    const ElementShape shape = sides.shape(side);
    const double size = length(side.edge.end - side.edge.start);
    for (const GaussPoint& g : gauss_rule(shape.degree + 2)) {
      const Point x = point_at(side.edge, g.at);
      const double s = dot(x - start, along) / all;
      const auto next =
          std::clamp<std::ptrdiff_t>(std::ranges::upper_bound(ends, s) - ends.begin(), 1, std::ssize(ends) - 1);
      const auto i = static_cast<std::size_t>(next);
      const double share = (s - ends[i - 1]) / (ends[i] - ends[i - 1]);
      add(i, share * size * g.weight, side, shape, x);
      add(i - 1, (1 - share) * size * g.weight, side, shape, x);
    }
  }
  for (std::size_t hat = 0; hat < ends.size(); ++hat) {
    HeldPoint& mean = points_.emplace_back();
    mean.part = sides.part;
    mean.at = (1 / weights[hat]) * at[hat];
    mean.values.resize(static_cast<Eigen::Index>(values[hat].size()));
    for (const auto& [function, value] : values[hat]) {
      mean.values(static_cast<Eigen::Index>(mean.functions.size())) = value / weights[hat];
      mean.functions.push_back(function);
    }
    mean.stiffness = stiffness[hat];
    mean.projector = held_projector(sides.prescribed.held, n);
    mean.to = to[hat] / weights[hat];
  }
}

void HeldEdges::add_groups(FunctionGroups& groups) const {
  for (const HeldPoint& point : points_) groups.add(point.functions);
}

void HeldEdges::begin_after(const HeldEdges& before, const Eigen::VectorXd& d) {
  for (HeldPoint& point : points_) {
    point.from = point.displacement(d);
    for (const HeldPoint& other : before.points_)
      if (distance(point.at, other.at) <= near_ && point.projector.isApprox(other.projector)) point.from = other.to;
  }
}

Eigen::VectorXd HeldEdges::start() const {
  Eigen::VectorXd start(2 * static_cast<Eigen::Index>(points_.size()));
  for (std::size_t i = 0; i < points_.size(); ++i) start.segment<2>(2 * static_cast<Eigen::Index>(i)) = points_[i].from;
  return start;
}

void HeldEdges::set_start(const Eigen::VectorXd& start) {
  for (std::size_t i = 0; i < points_.size(); ++i) points_[i].from = start.segment<2>(2 * static_cast<Eigen::Index>(i));
}

void HeldEdges::add_stiffness(SparseSystem& system) const {
  for (const HeldPoint& point : points_) {
    const Eigen::Index n = point.values.size();
    Eigen::MatrixXd block(2 * n, 2 * n);
    for (Eigen::Index a = 0; a < n; ++a)
      for (Eigen::Index b = 0; b < n; ++b)
        block.block<2, 2>(2 * a, 2 * b) = point.stiffness * point.values(a) * point.values(b) * point.projector;
    system.add_matrix(point.functions, block);
  }
}

Eigen::VectorXd HeldEdges::pull(double share, Eigen::Index size) const {
  Eigen::VectorXd force = Eigen::VectorXd::Zero(size);
  for (const HeldPoint& point : points_) {
    const Eigen::Vector2d pulled = point.stiffness * (point.projector * point.value(share));
    for (std::size_t a = 0; a < point.functions.size(); ++a)
      force.segment<2>(2 * point.functions[a]) += point.values(static_cast<Eigen::Index>(a)) * pulled;
  }
  return force;
}

std::vector<double> HeldEdges::driven(double share) const {
  std::vector<double> ways(parts_), weights(parts_);
  for (const HeldPoint& point : points_) {
    ways[point.part] += point.stiffness * (point.projector * point.value(share)).norm();
    weights[point.part] += point.stiffness;
  }
  for (std::size_t i = 0; i < parts_; ++i)
    if (weights[i] > 0) ways[i] /= weights[i];
  return ways;
}

std::vector<Resultant> HeldEdges::reactions(const Eigen::VectorXd& d, double share) const {
  std::vector<Resultant> sums(parts_);
  for (const HeldPoint& point : points_) {
    const Eigen::Vector2d force = point.stiffness * (point.projector * (point.value(share) - point.displacement(d)));
    sums[point.part].add(point.at, {force.x(), force.y()});
  }
  return sums;
}

}  // namespace keyblock
