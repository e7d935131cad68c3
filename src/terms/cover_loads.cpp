// Quadrature of forces; see cover_loads.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "terms/cover_loads.hpp"

#include "geometry/quadrature.hpp"
#include "geometry/segment.hpp"
#include "material/material_stress.hpp"

namespace keyblock {
namespace {

Eigen::Vector2d vector(Point p) {
  return {p.x, p.y};
}

/// Calls `visit(x, force)` with the shares of the body force on an element.
template <class Visit>
void visit_area(const Continuum& continuum, int element, int degree, Visit visit) {
  const BlockMaterial& material = continuum.material(element);
  if (!continuum.body_force && material.unit_weight == 0 && material.horizontal_force == 0) return;
  const auto loops = continuum.manifold.polygon(continuum.manifold.elements[static_cast<std::size_t>(element)]);
  for (const AreaPoint& p : polygon_rule(loops, degree + 2)) visit(p.at, p.weight * continuum.force_at(element, p.at));
}

/// The same of a traction on a side.
template <class Visit>
void visit_side(const Traction& traction, const ElementSide& side, int degree, Visit visit) {
  const double all = length(side.edge.end - side.edge.start);
  for (const GaussPoint& g : gauss_rule((degree + 4) / 2)) {
    const Point x = point_at(side.edge, g.at);
    visit(x, (all * g.weight) * traction.force(x, side.normal()));
  }
}

}  // namespace

void add_cover_body_force(const Continuum& continuum, const CoverBasis& basis, SparseSystem& system) {
  for (int e = 0; e < basis.element_count(); ++e) {
    const ElementShape shape = basis.shape(e);
    Eigen::VectorXd load = Eigen::VectorXd::Zero(2 * shape.function_count());
    visit_area(continuum, e, shape.degree,
               [&](Point x, Point force) { load += shape.displacement(x).transpose() * vector(force); });
    system.add_load(shape.functions, load);
  }
}

void add_cover_initial_stress(const Continuum& continuum, const CoverBasis& basis, SparseSystem& system) {
  for (int e = 0; e < basis.element_count(); ++e) {
    const ElementShape shape = basis.shape(e);
    Eigen::VectorXd load = Eigen::VectorXd::Zero(2 * shape.function_count());
    const auto loops = continuum.manifold.polygon(continuum.manifold.elements[static_cast<std::size_t>(e)]);
    for (const AreaPoint& p : polygon_rule(loops, shape.degree + 1))
      load -= p.weight * (shape.strain(p.at).transpose() * in_plane(continuum.initial_stress_at(e, p.at)));
    system.add_load(shape.functions, load);
  }
}

void add_traction(const Continuum& continuum, const CoverBasis& basis, const Traction& traction, SparseSystem& system) {
  for (const ElementSide& side : sides_along(continuum.manifold, traction.along)) {
    const ElementShape shape = basis.shape(side.element);
    Eigen::VectorXd load = Eigen::VectorXd::Zero(2 * shape.function_count());
    visit_side(traction, side, shape.degree,
               [&](Point x, Point force) { load += shape.displacement(x).transpose() * vector(force); });
    system.add_load(shape.functions, load);
  }
}

Resultant sum_of_loads(const Continuum& continuum, int degree) {
  Resultant sum;
  const auto add = [&](Point x, Point force) { sum.add(x, force); };
  for (int e = 0; e < static_cast<int>(continuum.manifold.elements.size()); ++e) visit_area(continuum, e, degree, add);
  for (const Traction& traction : continuum.tractions)
    for (const ElementSide& side : sides_along(continuum.manifold, traction.along))
      visit_side(traction, side, degree, add);
  for (const PointForce& load : continuum.point_forces) sum.add(load.at, load.force);
  return sum;
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
