// Quadrature of forces; see cover_loads.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "terms/cover_loads.hpp"

#include "geometry/quadrature.hpp"
#include "geometry/segment.hpp"

namespace keyblock {
namespace {

Eigen::Vector2d vector(Point p) {
  return {p.x, p.y};
}

}  // namespace

void add_cover_body_force(const Continuum& continuum, const CoverBasis& basis, SparseSystem& system) {
  if (!continuum.body_force) return;
  for (int e = 0; e < basis.element_count(); ++e) {
    const ElementShape shape = basis.shape(e);
    Eigen::VectorXd load = Eigen::VectorXd::Zero(2 * shape.function_count());
    const auto loops = continuum.manifold.polygon(continuum.manifold.elements[static_cast<std::size_t>(e)]);
    for (const AreaPoint& p : polygon_rule(loops, shape.degree + 2))
      load += p.weight * (shape.displacement(p.at).transpose() * vector(continuum.body_force(p.at)));
    system.add_load(shape.functions, load);
  }
}

void add_traction(const Continuum& continuum, const CoverBasis& basis, const Traction& traction, SparseSystem& system) {
  for (const ElementSide& side : sides_along(continuum.manifold, traction.along)) {
    const ElementShape shape = basis.shape(side.element);
    Eigen::VectorXd load = Eigen::VectorXd::Zero(2 * shape.function_count());
    const double all = length(side.edge.end - side.edge.start);
    for (const GaussPoint& g : gauss_rule((shape.degree + 4) / 2)) {
      const Point x = point_at(side.edge, g.at);
      load += all * g.weight * (shape.displacement(x).transpose() * vector(traction.force(x, side.normal())));
    }
    system.add_load(shape.functions, load);
  }
}

void add_point_force(const CoverBasis& basis, const PointForce& load, SparseSystem& system) {
  const ElementShape shape = basis.shape(load.element);
  system.add_load(shape.functions, shape.displacement(load.at).transpose() * vector(load.force));
}

void add_point_spring(const CoverBasis& basis, const PointSpring& spring, SparseSystem& system) {
  const ElementShape shape = basis.shape(spring.element);
  const Eigen::VectorXd along = shape.displacement(spring.at).transpose() * vector(spring.direction);
  system.add_matrix(shape.functions, spring.stiffness * along * along.transpose());
}

}  // namespace keyblock
