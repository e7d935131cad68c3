// Computes accelerations from the contacts and forces that the motion remembers.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/scene/acceleration.hpp"

#include <algorithm>
#include <cmath>

#include "contact/rows/gap.hpp"
#include "contact/solve/friction_newton.hpp"
#include "step/newton/tolerances.hpp"
#include "step/scene/contact_laws.hpp"
#include "step/scene/step_constraints.hpp"

namespace keyblock {
namespace {

using namespace tolerances;

Touches closed_of(const Motion& motion) {
  Touches touches;
  for (const auto& [touch, memory] : motion.closed.all()) touches.push_back(touch);
  return touches;
}

Eigen::VectorXd forces_of(const Motion& motion) {
  Eigen::VectorXd forces(static_cast<Eigen::Index>(2 * motion.closed.size()));
  Eigen::Index i = 0;
  for (const auto& [touch, memory] : motion.closed.all()) {
    forces[i++] = memory.normal;
    forces[i++] = memory.tangential;
  }
  return forces;
}

}  // namespace

UnknownsTable balanced_acceleration(const StandardScene& scene, const Motion& motion, double time) {
  const StepConstraints constraints(scene, motion, time, 0);
  ContactRows rows = contact_rows(scene.model, scene.reference, motion.q, closed_of(motion));
  const ContactRows of_constraints = constraints.rows(motion.q);
  rows.insert(rows.end(), of_constraints.begin(), of_constraints.end());
  Eigen::VectorXd forces(static_cast<Eigen::Index>(rows.size()));
  forces << forces_of(motion), constraints.remembered();
  const UnknownsTable loads = loads_at(scene, motion.q, time);
  const Flexibility inverse = mass_flexibility(scene);
  UnknownsTable a = answer(rows, inverse, forces);
  for (const auto& group : scene.groups) group->add_acceleration(loads, motion, inverse, a);
  return a;
}

UnknownsTable with_held_at_ease(const StandardScene& scene, const Motion& motion) {
  const Touches closed = without_springs(scene, closed_of(motion));
  if (closed.empty() && scene.held.empty()) return motion.a;
  const ContactRows rows = rows_with_points(scene, motion.q, closed);
  const Flexibility blocks = mass_flexibility(scene);
  const double goal = of_accelerations::kTolerance * largest_momentum(scene, motion.a) + of_accelerations::kSmallest;
  FrictionalProblem problem{
      ContactMatrix(rows, blocks), rates(rows, motion.a), {}, goal, of_accelerations::kLooser * goal, {}};
  for (const Touch& touch : closed) {
    const ContactMemory& memory = *motion.closed.of(touch);
    const double limit = contact_law(scene, motion.bonds, touch).force.limit(memory.normal);
    problem.laws.push_back(std::abs(memory.tangential) < (1 - of_accelerations::kAtLimit) * limit ? kHeld : kBilateral);
  }
  problem.laws.insert(problem.laws.end(), scene.held.size(), kHeld);
  // Nothing can open, so that the fallback of `solve` could not improve on Newton's method.
  const Eigen::VectorXd forces = newton(problem, Eigen::VectorXd::Zero(problem.w.rows())).forces;
  return plus(motion.a, 1, answer(rows, blocks, forces));
}

}  // namespace keyblock
