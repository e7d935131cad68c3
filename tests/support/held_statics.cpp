// Assembles stiffness and mass of Shi's step and solves densely: the scenes are small.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/held_statics.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "legacy/step/cover_unknowns.hpp"
#include "legacy/step/hanging.hpp"
#include "legacy/terms/body_force.hpp"
#include "legacy/terms/elastic.hpp"
#include "legacy/terms/fixed_point.hpp"
#include "legacy/terms/inertia.hpp"
#include "legacy/terms/initial_stress.hpp"
#include "legacy/terms/point_load.hpp"
#include "material/elastic.hpp"
#include "model/shared_covers.hpp"

namespace keyblock::support {
namespace {

System of_terms(const ShiScene& scene, const State& state, const std::vector<Term>& terms) {
  const double dt = std::sqrt(2.0);  // 2 M / dt² is M
  return CoverUnknowns(scene.model, state).of_covers(assemble(terms, {scene.model, state, scene.settings, dt}));
}

Eigen::MatrixXd dense(const System& system, const std::vector<int>& rows) {
  Eigen::MatrixXd matrix(rows.size(), rows.size());
  Eigen::MatrixXd whole = Eigen::MatrixXd::Zero(system.matrix.row_count(), system.matrix.row_count());
  for (int i = 0; i < system.matrix.block_count(); ++i) {
    for (const auto& [j, block] : system.matrix.row(i)) {
      whole.block(system.matrix.first_row(i), system.matrix.first_row(j), block.rows(), block.cols()) = block;
      whole.block(system.matrix.first_row(j), system.matrix.first_row(i), block.cols(), block.rows()) =
          block.transpose();
    }
  }
  return whole(rows, rows);
}

std::set<int> held_bodies_of(const ShiScene& scene, const std::vector<int>& bodies) {
  std::map<int, std::set<std::pair<double, double>>> points;
  for (const CarriedPoint& p : scene.model.fixed_points)
    points[bodies[static_cast<std::size_t>(p.element.value)]].insert({p.start.x, p.start.y});
  std::set<int> held;
  for (const auto& [body, places] : points)
    if (places.size() > 1) held.insert(body);
  return held;
}

}  // namespace

double HeldStatics::remaining_share(double dt, int steps) const {
  return std::pow(1 + omega * omega * dt * dt / 2, -steps);
}

Point displacement_of(const ShiScene& scene, const Increments& increments, const CarriedPoint& point) {
  const State state = start(scene).state;
  const Eigen::Vector2d u = basis_at(scene.model, state, point.element, point.start) * increments[point.element];
  return {u.x(), u.y()};
}

HeldStatics held_statics(ShiScene scene, double spring) {
  scene.settings.fixed_point_factor = spring / scene.settings.contact_penalty;
  const Model& model = scene.model;
  const State state = start(scene).state;
  HeldStatics result;
  const std::vector<int> bodies = body_numbers(model);
  const std::set<int> held = held_bodies_of(scene, bodies);
  result.bodies = static_cast<int>(std::set<int>(bodies.begin(), bodies.end()).size());
  result.held_bodies = static_cast<int>(held.size());
  std::set<int> covers;
  for (ElementIndex e : indices(model.elements)) {
    result.is_held.push_back(held.contains(bodies[static_cast<std::size_t>(e.value)]));
    if (result.is_held.back()) covers.insert(model.elements[e].covers.begin(), model.elements[e].covers.end());
  }
  std::vector<int> rows;
  for (const int cover : covers) {
    rows.push_back(2 * cover);
    rows.push_back(2 * cover + 1);
  }
  const System stiff =
      of_terms(scene, state, {add_fixed_point, add_elastic, add_initial_stress, add_body_force, add_point_load});
  const Eigen::MatrixXd stiffness = dense(stiff, rows);
  const Eigen::MatrixXd mass = dense(of_terms(scene, state, {add_inertia}), rows);
  Solution solution;
  solution.x = Eigen::VectorXd::Zero(stiff.matrix.row_count());
  const Eigen::VectorXd load = stiff.load(rows);
  if (!rows.empty()) {
    const Eigen::VectorXd x = stiffness.ldlt().solve(load);
    solution.x(rows) = x;
  }
  result.increments = CoverUnknowns(model, state).increments(solution);
  if (rows.empty()) return result;
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(stiffness, mass, Eigen::EigenvaluesOnly);
  result.omega = std::sqrt(std::max(0.0, modes.eigenvalues()[0]));
  result.least_stress_yy = 1e300;
  result.greatest_stress_yy = -1e300;
  for (ElementIndex e : indices(model.elements)) {
    if (!result.is_held[static_cast<std::size_t>(e.value)]) continue;
    const Element& element = model.elements[e];
    for (VertexIndex v : element.vertices()) {
      const Point u = element.basis->displacement(result.increments[e], state.vertices[v] - state.elements[e].centroid);
      result.greatest_displacement = std::max(result.greatest_displacement, length(u));
    }
    const Eigen::Vector3d stress =
        plane_stress_modulus(model.material_of(element)) * (element.basis->strain() * result.increments[e]);
    result.least_stress_yy = std::min(result.least_stress_yy, stress[1]);
    result.greatest_stress_yy = std::max(result.greatest_stress_yy, stress[1]);
  }
  return result;
}

}  // namespace keyblock::support
