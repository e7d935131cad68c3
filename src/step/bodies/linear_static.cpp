// Assembles stiffness, ghost penalty, supports and loads, and solves the system; see linear_static.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/bodies/linear_static.hpp"

#include "material/material_stress.hpp"
#include "terms/cover_loads.hpp"
#include "terms/cover_stiffness.hpp"
#include "terms/ghost_penalty.hpp"
#include "terms/nitsche.hpp"

namespace keyblock {
namespace {

Eigen::VectorXd unknowns_of(const ContinuumSolution& solution, const ElementShape& shape) {
  Eigen::VectorXd d(2 * shape.function_count());
  for (std::size_t a = 0; a < shape.functions.size(); ++a)
    d.segment<2>(static_cast<Eigen::Index>(2 * a)) = solution.solution.x.segment<2>(2 * shape.functions[a]);
  return d;
}

void add_face_forces(const ContactRows& rows, const Eigen::VectorXd& forces, SparseSystem& system) {
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (const SharedEntry& entry : rows[i].shared)
      system.add_load({&entry.function, 1}, forces[static_cast<Eigen::Index>(i)] * Eigen::Vector2d(entry.x, entry.y));
}

}  // namespace

FunctionGroups coupled_functions(const CoverBasis& basis, const std::vector<GhostPair>& pairs) {
  FunctionGroups groups;
  for (int e = 0; e < basis.element_count(); ++e) groups.add(basis.shape(e).functions);
  for (const GhostPair& pair : pairs) groups.add(pair.functions);
  return groups;
}

Definiteness definiteness_of(CoverFunctions functions) {
  const bool is_independent = functions == CoverFunctions::constant || functions == CoverFunctions::derived;
  return is_independent ? Definiteness::definite : Definiteness::semidefinite;
}

Point ContinuumSolution::displacement(int element, Point x) const {
  const ElementShape shape = basis.shape(element);
  const Eigen::Vector2d u = shape.displacement(x) * unknowns_of(*this, shape);
  return {u.x(), u.y()};
}

Eigen::Vector3d ContinuumSolution::strain(int element, Point x) const {
  const ElementShape shape = basis.shape(element);
  return shape.strain(x) * unknowns_of(*this, shape);
}

double ContinuumSolution::rotation(int element, Point x) const {
  const ElementShape shape = basis.shape(element);
  const Eigen::Matrix2Xd gradients = shape.gradients(x);
  const Eigen::VectorXd d = unknowns_of(*this, shape);
  double twice = 0;
  for (Eigen::Index a = 0; a < gradients.cols(); ++a)
    twice += d(2 * a + 1) * gradients(0, a) - d(2 * a) * gradients(1, a);
  return twice / 2;
}

void add_supports_and_loads(const Continuum& continuum, const CoverBasis& basis, SparseSystem& system) {
  add_cover_body_force(continuum, basis, system);
  for (const PrescribedDisplacement& part : continuum.prescribed) add_prescribed(continuum, basis, part, system);
  for (const Traction& part : continuum.tractions) add_traction(continuum, basis, part, system);
  for (const PointForce& force : continuum.point_forces) add_point_force(basis, force, system);
  for (const PointSpring& spring : continuum.point_springs) add_point_spring(basis, spring, system);
}

SparseSystem assemble_static(const Continuum& continuum, const CoverBasis& basis) {
  const std::vector<GhostPair> pairs = ghost_pairs(continuum.manifold, basis);
  SparseSystem system(basis.function_count(), coupled_functions(basis, pairs));
  add_cover_stiffness(continuum, basis, system);
  add_ghost_penalty(continuum, basis, pairs, system);
  add_cover_initial_stress(continuum, basis, system);
  add_supports_and_loads(continuum, basis, system);
  return system;
}

ContinuumSolution solve_static(const Continuum& continuum, const std::vector<JointMaterial>& joints) {
  CoverBasis basis = basis_of(continuum);
  // Far from the tip, near-tip functions are nearly polynomials.
  const Definiteness definiteness =
      basis.has_tip_functions() ? Definiteness::semidefinite : definiteness_of(continuum.functions);
  SparseSystem system = assemble_static(continuum, basis);
  const auto factor = std::make_shared<SparseFactor>(system.lower(), definiteness);
  factor->factorise(system.lower());
  ContinuumSolution found{std::move(basis), solve(system, *factor)};
  if (!continuum.faces_touch) return found;
  const std::vector<FacePoint> points = face_points(continuum, found.basis);
  const ContactRows rows = face_rows(found.basis, points);
  const FaceForces pressed = face_forces(points, rows, joints, factor, found.solution.x);
  if (!pressed.forces.isZero(0)) {
    add_face_forces(rows, pressed.forces, system);
    found.solution = solve(system, *factor);
  }
  found.faces = face_contacts(points, rows, pressed.forces, found.solution.x);
  found.faces_settled = pressed.converged;
  return found;
}

ForceBalance balance_of(const Continuum& continuum, const ContinuumSolution& solution) {
  ForceBalance balance;
  balance.loads = sum_of_loads(continuum, solution.basis.degree());
  for (const PointSpring& spring : continuum.point_springs) {
    const Point u = solution.displacement(spring.element, spring.at);
    balance.springs.add(spring.at, (-spring.stiffness * dot(u, spring.direction)) * spring.direction);
  }
  for (const PrescribedDisplacement& part : continuum.prescribed)
    balance.supports.push_back(reaction_of(continuum, solution.basis, part, solution.solution.x));
  return balance;
}

Stress stress_at(const Continuum& continuum, const ContinuumSolution& solution, int element, Point x) {
  const Stress start = continuum.initial_stress_at(element, x);
  return with_across(in_plane(start) + continuum.modulus(element) * solution.strain(element, x), start,
                     share_across(continuum.material(element), continuum.plane));
}

}  // namespace keyblock
