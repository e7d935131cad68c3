// Point by point along the edges; see held_edges.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "terms/held_edges.hpp"

#include "geometry/box.hpp"
#include "geometry/quadrature.hpp"
#include "geometry/segment.hpp"
#include "terms/stabilisation.hpp"

namespace keyblock {
namespace {

constexpr double kSamePlace = 1e-9;  // of the extent: edges of two scenes are cut from the same lines

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

HeldEdges::HeldEdges(const Continuum& continuum, const CoverBasis& basis) : parts_(continuum.prescribed.size()) {
  Box box;
  for (const ElementCorner& corner : continuum.manifold.corners) box.add(corner.position);
  near_ = kSamePlace * length(box.size());
  for (std::size_t part = 0; part < parts_; ++part) {
    const PrescribedDisplacement& prescribed = continuum.prescribed[part];
    for (const ElementSide& side : sides_along(continuum.manifold, prescribed.along)) {
      const ElementShape shape = basis.shape(side.element);
      const Point n = side.normal();
      const double stiffness = kHeldSprings * continuum.modulus(side.element)(0, 0) / shape.frame.size;
      const double all = length(side.edge.end - side.edge.start);
      for (const GaussPoint& g : gauss_rule(shape.degree + 2)) {
        const Point x = point_at(side.edge, g.at);
        const Point value = prescribed.value(x, n);
        HeldPoint& held = points_.emplace_back();
        held.part = part;
        held.at = x;
        held.functions.assign(shape.functions.begin(), shape.functions.end());
        held.values = shape.values(x);
        held.stiffness = stiffness * all * g.weight;
        held.projector = held_projector(prescribed.held, n);
        held.to = {value.x, value.y};
      }
    }
  }
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
