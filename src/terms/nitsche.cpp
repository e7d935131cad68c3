// Integrates edge by edge; see nitsche.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "terms/nitsche.hpp"

#include "material/material_stress.hpp"
#include "terms/held_edges.hpp"
#include "terms/stabilisation.hpp"

namespace keyblock {
namespace {

/// Returns the matrix S with σn = S σ.
Eigen::Matrix<double, 2, 3> on_plane(Point n) {
  Eigen::Matrix<double, 2, 3> s;
  s << n.x, 0, n.y, 0, n.y, n.x;
  return s;
}

/// Support at one quadrature point.
struct HeldPoint {
  Point at;
  double weight = 0;
  Eigen::Matrix2d projector;
  Eigen::Vector2d value;      ///< g
  Eigen::Matrix2Xd held;      ///< P T
  Eigen::Matrix2Xd traction;  ///< of the unknowns
  Eigen::Vector2d initial;    ///< traction of the initial stress
};

// Near-tip functions of small pieces extend into no neighbour, so no penalty is large enough for their stress there.
bool knows_its_stress(const Continuum& continuum, const ElementShape& shape, int element) {
  return !continuum.material(element).is_nonlinear() && shape.tip == nullptr;
}

template <class Visit>
void visit_points(const Continuum& continuum, const ElementShape& shape, const PrescribedDisplacement& prescribed,
                  const ElementSide& side, Visit visit) {
  const Point n = side.normal();
  const Eigen::Matrix2d p = held_projector(prescribed.held, n);
  const bool is_linear = knows_its_stress(continuum, shape, side.element);
  const Eigen::Matrix3d modulus =
      is_linear ? continuum.modulus(side.element) : Eigen::Matrix3d(Eigen::Matrix3d::Zero());
  for (const EdgePoint& q : edge_rule(side, shape, shape.degree + 2)) {
    const Point x = q.at;
    const Point value = prescribed.value(x, n);
    visit(HeldPoint{x, q.weight, p, Eigen::Vector2d(value.x, value.y), p * shape.displacement(x),
                    on_plane(n) * modulus * shape.strain(x),
                    on_plane(n) * in_plane(continuum.initial_stress_at(side.element, x))});
  }
}

double penalty(const Continuum& continuum, CoverFunctions functions, const ElementShape& shape, int element) {
  if (!knows_its_stress(continuum, shape, element))
    return kHeldSprings * continuum.modulus(element)(0, 0) / shape.frame.size;
  return stabilisation(functions).nitsche * shape.degree * shape.degree * continuum.modulus(element)(0, 0) /
         shape.frame.size;
}

}  // namespace

void add_prescribed(const Continuum& continuum, const CoverBasis& basis, const PrescribedDisplacement& prescribed,
                    SparseSystem& system) {
  for (const ElementSide& side : sides_along(continuum.manifold, prescribed.along)) {
    const ElementShape shape = basis.shape(side.element);
    const double beta = penalty(continuum, basis.functions(side.element), shape, side.element);
    const Eigen::Index n = 2 * shape.function_count();
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
    Eigen::VectorXd load = Eigen::VectorXd::Zero(n);
    visit_points(continuum, shape, prescribed, side, [&](const HeldPoint& h) {
      const Eigen::MatrixXd cross = h.traction.transpose() * h.held;
      matrix += h.weight * (beta * h.held.transpose() * h.held - cross - cross.transpose());
      load += h.weight * ((beta * h.held - h.projector * h.traction).transpose() * h.value);
      load += h.weight * (h.held.transpose() * h.initial);
    });
    system.add_matrix(shape.functions, matrix);
    system.add_load(shape.functions, load);
  }
}

Resultant reaction_of(const Continuum& continuum, const CoverBasis& basis, const PrescribedDisplacement& prescribed,
                      const Eigen::VectorXd& unknowns) {
  Resultant sum;
  for (const ElementSide& side : sides_along(continuum.manifold, prescribed.along)) {
    const ElementShape shape = basis.shape(side.element);
    const double beta = penalty(continuum, basis.functions(side.element), shape, side.element);
    Eigen::VectorXd d(2 * shape.function_count());
    for (std::size_t a = 0; a < shape.functions.size(); ++a)
      d.segment<2>(static_cast<Eigen::Index>(2 * a)) = unknowns.segment<2>(2 * shape.functions[a]);
    visit_points(continuum, shape, prescribed, side, [&](const HeldPoint& h) {
      const Eigen::Vector2d off = h.held * d - h.projector * h.value;
      const Eigen::Vector2d force = h.weight * (h.projector * (h.traction * d + h.initial) - beta * off);
      sum.add(h.at, {force.x(), force.y()});
    });
  }
  return sum;
}

}  // namespace keyblock
