// Computes the forces of rigid blocks first, then of elastic ones; see start_forces.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/rest/start_forces.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <utility>

#include "contact/rows/gap.hpp"
#include "contact/solve/friction_newton.hpp"
#include "step/newton/tolerances.hpp"
#include "step/scene/acceleration.hpp"
#include "step/scene/contact_laws.hpp"
#include "step/scene/step_constraints.hpp"

namespace keyblock {
namespace {

using namespace tolerances;

Table<ElementIndex, UnknownBlock> scaled(double by, Table<ElementIndex, UnknownBlock> blocks) {
  for (UnknownBlock& block : blocks) block *= by;
  return blocks;
}

// A bolt pulls with λ = −f along its row and has no force across.
Eigen::VectorXd pretensions(const StandardScene& scene) {
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(2 * scene.model.bolts.size()));
  for (std::size_t i = 0; i < scene.model.bolts.size(); ++i)
    if (scene.model.bolts[i].is_spring()) forces[static_cast<Eigen::Index>(2 * i)] = -scene.model.bolts[i].pretension;
  return forces;
}

bool has_light_blocks(const StandardScene& scene, double heaviest) {
  return std::ranges::any_of(scene.bodies(), [&](const Body& body) {
    return body.mass.rows() > 0 && body.mass(0, 0) < StartForces::kLightest * heaviest;
  });
}

}  // namespace

StartForces::StartForces(const StandardScene& of, Motion start)
    : scene(of),
      motion(std::move(start)),
      drawn(motion.q),
      loads(loads_at(of, motion.q, 0)),
      rigid(rigid_mass_inverses(of.bodies())) {
  for (const Unknowns& a : product(rigid, loads))
    if (a.size() > 0) acceleration_of_loads = std::max(acceleration_of_loads, a.head<2>().norm());
  const ContactRows of_bolts = bolt_rows(scene.model, scene.reference, motion.q);
  if (!of_bolts.empty()) loads = plus(loads, 1, answer(of_bolts, {identities()}, pretensions(scene)));
  scales = scales_of(scene, loads, motion.q, motion.v);
  add_centrifugal_force(scene, motion.v, loads);
  tolerance = of_start_forces::kForceTolerance * scales.force;
  acceptable = of_start_forces::kLooser * tolerance;
  for (const Body& body : scene.bodies())
    if (body.mass.rows() > 0) heaviest = std::max(heaviest, body.mass(0, 0));
  touches = resting_touches(scene, motion, scales);
}

ContactLaw StartForces::law(std::size_t touch) const {
  return contact_law(scene, motion.bonds, touches[touch]);
}

void StartForces::make_rows() {
  rows = contact_rows(scene.model, scene.reference, motion.q, touches);
  if (!bolts.empty()) {
    ContactRows all = bolt_rows(scene.model, scene.reference, motion.q);
    for (const std::size_t number : bolts) {
      for (ContactRow* row : {&all[2 * number], &all[2 * number + 1]}) {
        row->of_vertex = -row->of_vertex;
        row->of_edge = -row->of_edge;
        rows.push_back(*row);
      }
    }
  }
  if (scene.held.empty()) return;
  const ContactRows of_points = point_rows(scene.model, scene.reference, motion.q, scene.held);
  rows.insert(rows.end(), of_points.begin(), of_points.end());
}

void StartForces::find() {
  const double dt = scene.settings.time_step;
  forces = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(rows.size()));
  if (!rows.empty()) {
    FrictionalProblem problem{ContactMatrix(rows, {scaled(dt, rigid)}),
                              dt * rates(rows, product(rigid, loads)),
                              {},
                              tolerance,
                              acceptable,
                              {}};
    for (const Touch& touch : touches) problem.laws.push_back(contact_law(scene, motion.bonds, touch).force);
    const Eigen::VectorXd v = rates(rows, motion.v);
    for (std::size_t i = 0; i < touches.size(); ++i) problem.b[tangential(i)] += v[tangential(i)];
    add_bolts(problem);
    problem.laws.insert(problem.laws.end(), scene.held.size(), kHeld);
    if (has_light_blocks(scene, heaviest))
      problem.scale = diagonal_of(rows, {scaled(dt, counted_as(1))}, problem.w.shared()) + problem.w.added();
    forces = solve(problem, forces).forces;
  }
  acceleration = plus(product(rigid, loads), 1, answer(rows, {rigid}, forces));
}

void StartForces::distribute() {
  if (rows.empty()) return;
  double softest = scene.normal_stiffness();
  for (std::size_t i = 0; i < bolts.size(); ++i) softest = std::min(softest, bolt(i).stiffness);
  Table<ElementIndex, UnknownBlock> flexibility;
  UnknownsTable increments;
  for (ElementIndex e : indices(scene.bodies())) {
    const Body& body = scene.bodies()[e];
    const UnknownBlock a = body.sum_of(softest / (of_start_forces::kLong * heaviest), 1);
    flexibility.push_back(a.rows() > 0 ? UnknownBlock(a.llt().solve(UnknownBlock::Identity(a.rows(), a.cols()))) : a);
    const Unknowns unbalanced =
        loads[e] + body.initial_stress - body.elastic_force(motion.q[e]) - body.mass * acceleration[e];
    increments.push_back(flexibility[e] * unbalanced);
  }
  FrictionalProblem problem{ContactMatrix(rows, {flexibility}), rates(rows, increments), {}, tolerance, acceptable, {}};
  const auto vertices = vertices_at(scene.model, scene.reference, motion.q);
  const double beyond = of_start_forces::kBeyond * problem.b.cwiseAbs().maxCoeff() +
                        of_start_forces::kBeyond * problem.w.diagonal().maxCoeff() * forces.cwiseAbs().maxCoeff();
  const Eigen::VectorXd slip = slips();
  for (std::size_t i = 0; i < touches.size(); ++i) {
    const ContactLaw law = contact_law(scene, motion.bonds, touches[i]);
    const Eigen::Index n = tangential(i) - 1;
    problem.laws.push_back(law.force);
    problem.w.add_to_diagonal(n, law.normal_compliance);
    problem.w.add_to_diagonal(n + 1, law.tangential_compliance);
    problem.b[n] += gap_of(touches[i], vertices) - law.rest_gap;
    if (law.is_bonded) problem.b[n + 1] += slip[n + 1];
    const double force = forces[n + 1];
    if (std::abs(force) > 0 && std::abs(force) >= of_start_forces::kSliding * law.force.limit(normal(i)))
      problem.b[n + 1] = force > 0 ? -beyond : beyond;
  }
  add_bolts(problem);
  for (std::size_t i = 0; i < bolts.size(); ++i) {
    problem.w.add_to_diagonal(bolt_row(i), 1 / bolt(i).stiffness);
    problem.b[bolt_row(i)] -= elongation(i);
  }
  problem.laws.insert(problem.laws.end(), scene.held.size(), kHeld);
  const Eigen::VectorXd off = held_offsets();
  problem.b.tail(off.size()) += off;
  problem.proximal = of_start_forces::kRegular * problem.w.diagonal();
  problem.acceptable = tolerance;
  const FrictionalSolution found = newton(problem, elastic.size() > 0 ? elastic : forces);
  if (found.residual <= acceptable) elastic = forces = found.forces;
}

void StartForces::add_bolts(FrictionalProblem& problem) const {
  for (std::size_t i = 0; i < bolts.size(); ++i) {
    problem.laws.push_back({});
    problem.w.add_to_diagonal(bolt_row(i) + 1, 1);
  }
}

Table<ElementIndex, UnknownBlock> StartForces::counted_as(double share) const {
  Table<ElementIndex, UnknownBlock> blocks = rigid;
  for (ElementIndex e : indices(blocks))
    if (blocks[e].rows() > 0) blocks[e] *= std::min(1.0, scene.bodies()[e].mass(0, 0) / (share * heaviest));
  return blocks;
}

bool StartForces::carries(std::size_t touch) const {
  return normal(touch) != 0 || law(touch).is_bonded;
}

Eigen::VectorXd StartForces::slips() const {
  return rates(rows, plus(motion.q, -1, drawn));
}

Eigen::VectorXd StartForces::gaps_from_wanted() const {
  const auto vertices = vertices_at(scene.model, scene.reference, motion.q);
  Eigen::VectorXd gaps = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(2 * touches.size()));
  const Eigen::VectorXd slip = slips();
  for (std::size_t i = 0; i < touches.size(); ++i) {
    const ContactLaw of = law(i);
    const Eigen::Index t = tangential(i);
    gaps[t - 1] = gap_of(touches[i], vertices) - of.rest_gap + normal(i) * of.normal_compliance;
    if (of.is_bonded) gaps[t] = slip[t] + forces[t] * of.tangential_compliance;
  }
  return gaps;
}

Eigen::VectorXd StartForces::held_offsets() const {
  if (scene.held.empty()) return {};
  return offsets(scene.model, scene.reference, motion.q, scene.held, 0);
}

double StartForces::missing() const {
  const Eigen::VectorXd gaps = gaps_from_wanted();
  double sum = 0;
  for (std::size_t i = 0; i < touches.size(); ++i) {
    const double gap = gaps[tangential(i) - 1];
    sum += (carries(i) ? std::abs(gap) : std::max(0.0, -gap)) + std::abs(gaps[tangential(i)]);
  }
  for (std::size_t i = 0; i < bolts.size(); ++i)
    if (tension(i) > 0) sum += std::abs(elongation(i) - tension(i) / bolt(i).stiffness);
  return sum + held_offsets().cwiseAbs().sum();
}

bool StartForces::balances() const {
  const UnknownsTable made = plus(product(rigid, loads), 1, answer(rows, {rigid}, forces));
  for (ElementIndex e : indices(made))
    if (made[e].size() > 0 &&
        (made[e] - acceleration[e]).head<2>().norm() > of_start_forces::kUnbalanced * acceleration_of_loads)
      return false;
  return true;
}

int StartForces::carrying_bolts() const {
  int count = 0;
  for (std::size_t i = 0; i < bolts.size(); ++i) count += tension(i) > 0 ? 1 : 0;
  return count;
}

UnknownsTable StartForces::product(const Table<ElementIndex, UnknownBlock>& blocks, const UnknownsTable& x) {
  UnknownsTable result = x;
  for (ElementIndex e : indices(x)) result[e] = blocks[e] * x[e];
  return result;
}

Table<ElementIndex, UnknownBlock> StartForces::identities() const {
  Table<ElementIndex, UnknownBlock> all = rigid;
  for (UnknownBlock& block : all) block.setIdentity();
  return all;
}

}  // namespace keyblock
