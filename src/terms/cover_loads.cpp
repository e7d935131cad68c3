// Integrates forces by quadrature; see cover_loads.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "terms/cover_loads.hpp"

#include "material/material_stress.hpp"

namespace keyblock {
namespace {

Eigen::Vector2d vector(Point p) {
  return {p.x, p.y};
}

bool has_body_force(const Continuum& continuum, int element) {
  const BlockMaterial& material = continuum.material(element);
  return continuum.body_force || material.unit_weight != 0 || material.horizontal_force != 0;
}

/// Calls `visit(x, force)` with the contributions of the body force on an element of this shape.
template <class Visit>
void visit_area(const Continuum& continuum, int element, const ElementShape& shape, Visit visit) {
  if (!has_body_force(continuum, element)) return;
  for (const AreaPoint& p : area_rule(continuum.manifold, element, shape, shape.degree + 2))
    visit(p.at, p.weight * continuum.force_at(element, p.at));
}

/// Exact for tractions of third order.
std::vector<EdgePoint> points_of_traction(const ElementSide& side, const ElementShape& shape) {
  return edge_rule(side, shape, (shape.degree + 4) / 2);
}

/// Calls `visit(x, force)` with the contributions of a traction on a side.
template <class Visit>
void visit_side(const Traction& traction, const ElementSide& side, const ElementShape& shape, Visit visit) {
  for (const EdgePoint& p : points_of_traction(side, shape))
    visit(p.at, p.weight * traction.force(p.at, side.normal()));
}

/// Returns a shape of this degree for integration only.
ElementShape plain_shape(int degree) {
  return {degree, {}, {nullptr, 0, 0}, {}};
}

}  // namespace

void add_cover_body_force(const Continuum& continuum, const CoverBasis& basis, SparseSystem& system) {
  for (int e = 0; e < basis.element_count(); ++e) {
    const ElementShape shape = basis.shape(e);
    Eigen::VectorXd load = Eigen::VectorXd::Zero(2 * shape.function_count());
    visit_area(continuum, e, shape,
               [&](Point x, Point force) { load += shape.displacement(x).transpose() * vector(force); });
    system.add_load(shape.functions, load);
  }
}

void add_cover_initial_stress(const Continuum& continuum, const CoverBasis& basis, SparseSystem& system) {
  for (int e = 0; e < basis.element_count(); ++e) {
    const ElementShape shape = basis.shape(e);
    Eigen::VectorXd load = Eigen::VectorXd::Zero(2 * shape.function_count());
    for (const AreaPoint& p : area_rule(continuum.manifold, e, shape, shape.degree + 1))
      load -= p.weight * (shape.strain(p.at).transpose() * in_plane(continuum.initial_stress_at(e, p.at)));
    system.add_load(shape.functions, load);
  }
}

void add_traction(const Continuum& continuum, const CoverBasis& basis, const Traction& traction, SparseSystem& system) {
  for (const ElementSide& side : sides_along(continuum.manifold, traction.along)) {
    const ElementShape shape = basis.shape(side.element);
    Eigen::VectorXd load = Eigen::VectorXd::Zero(2 * shape.function_count());
    visit_side(traction, side, shape,
               [&](Point x, Point force) { load += shape.displacement(x).transpose() * vector(force); });
    system.add_load(shape.functions, load);
  }
}

ChangingLoads::ChangingLoads(const Continuum& continuum, const CoverBasis& basis) : following_(continuum, basis) {
  for (const ChangingTraction& traction : continuum.changing_tractions)
    for (const ElementSide& side : sides_along(continuum.manifold, traction.along)) {
      const ElementShape shape = basis.shape(side.element);
      Side& loaded = sides_.emplace_back(
          Side{traction.force, side.normal(), {shape.functions.begin(), shape.functions.end()}, {}});
      for (const EdgePoint& p : points_of_traction(side, shape))
        loaded.samples.push_back({p.at, p.weight, shape.displacement(p.at)});
    }
}

void ChangingLoads::add(const Eigen::VectorXd& d, double time, Eigen::VectorXd& loads) const {
  following_.add(d, time, loads);
  for (const Side& side : sides_) {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(2 * static_cast<Eigen::Index>(side.functions.size()));
    for (const Sample& sample : side.samples)
      sum += sample.weight * (sample.displacement.transpose() * vector(side.force(sample.at, side.normal, time)));
    for (std::size_t i = 0; i < side.functions.size(); ++i)
      loads.segment<2>(2 * side.functions[i]) += sum.segment<2>(2 * static_cast<Eigen::Index>(i));
  }
}

FollowingLoads::FollowingLoads(const Continuum& continuum, const CoverBasis& basis) {
  for (const FollowingPressure& pressed : continuum.pressures)
    for (const ElementSide& side : sides_along(continuum.manifold, pressed.along)) {
      const ElementShape shape = basis.shape(side.element);
      const Point along = side.edge.end - side.edge.start, normal = side.normal();
      Side& loaded = sides_.emplace_back(Side{pressed.pressure,
                                              normal,
                                              dot(Point{along.y, -along.x}, normal) > 0 ? 1.0 : -1.0,
                                              shape.displacement(side.edge.end) - shape.displacement(side.edge.start),
                                              {shape.functions.begin(), shape.functions.end()},
                                              {}});
      for (const EdgePoint& p : points_of_traction(side, shape))
        loaded.samples.push_back({p.at, p.weight / length(along), shape.displacement(p.at)});
    }
}

void FollowingLoads::add(const Eigen::VectorXd& d, double time, Eigen::VectorXd& loads) const {
  if (d.size() == 0) return;
  for (const Side& side : sides_) {
    const auto count = static_cast<Eigen::Index>(side.functions.size());
    Eigen::VectorXd own(2 * count);
    for (Eigen::Index i = 0; i < count; ++i)
      own.segment<2>(2 * i) = d.segment<2>(2 * side.functions[static_cast<std::size_t>(i)]);
    const Eigen::Vector2d stretch = side.stretch * own;
    const Eigen::Vector2d change = side.turn * Eigen::Vector2d(stretch.y(), -stretch.x());
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(2 * count);
    for (const Sample& sample : side.samples)
      sum -= sample.weight * side.pressure(sample.at, side.normal, time) * (sample.displacement.transpose() * change);
    for (Eigen::Index i = 0; i < count; ++i)
      loads.segment<2>(2 * side.functions[static_cast<std::size_t>(i)]) += sum.segment<2>(2 * i);
  }
}

Resultant sum_of_loads(const Continuum& continuum, int degree) {
  Resultant sum;
  const ElementShape shape = plain_shape(degree);
  const auto add = [&](Point x, Point force) { sum.add(x, force); };
  for (int e = 0; e < static_cast<int>(continuum.manifold.elements.size()); ++e) visit_area(continuum, e, shape, add);
  for (const Traction& traction : continuum.tractions)
    for (const ElementSide& side : sides_along(continuum.manifold, traction.along))
      visit_side(traction, side, shape, add);
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
