// Treats bolts and fixed points as forces of a step, next to those of contacts.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "contact/rows/constraints.hpp"
#include "contact/solve/frictional_problem.hpp"
#include "step/scene/standard_scene.hpp"

namespace keyblock {

/// Constraints of a step: unbroken spring bolts, then fixed points, each with a pair of forces. A bolt is a spring
/// along its direction with the force f = pretension + stiffness × elongation. Over a step it has
///     λ = −((1−θ) f0 + θ f1) ≥ −strength,
/// θ the weight of the elastic force; 1/2, the mean of both ends, conserves its energy (Simo, Tarnow & Wong 1992). A
/// point is fixed in x and y at its target for the end of the step.
class StepConstraints {
 public:
  StepConstraints(const StandardScene& scene, const Motion& start, double time, double dt, double weight = 1);

  std::size_t count() const { return bolts_.size() + points_.size(); }
  std::size_t bolt_count() const { return bolts_.size(); }
  /// Returns the forces at the start.
  Eigen::VectorXd remembered() const;

  /// Returns the rows of all constraints at q.
  ContactRows rows(const UnknownsTable& q) const;

  /// Returns the length over the force of the step for one constraint; 0 for a point.
  double compliance(std::size_t constraint) const;
  ForceLaw law(std::size_t constraint) const;

  /// Returns the distances of constraints from their targets at q without further force: 2i normal, 2i + 1 across.
  Eigen::VectorXd gaps(const UnknownsTable& q) const;

  /// Returns the force of a bolt after the step, its strength if it broke.
  double at_end(std::size_t bolt, const Motion& end) const;

  /// Returns the elongations of the bolts at q.
  Eigen::VectorXd elongation(const UnknownsTable& q) const;

  /// Returns the memory after a step with these forces that ends at q; bolts at their strength are broken.
  ConstraintMemory memory(const Eigen::VectorXd& forces, const UnknownsTable& q) const;

 private:
  const StandardScene& scene_;
  const Motion& start_;
  std::vector<std::size_t> bolts_;
  const std::vector<HeldPair>& points_;
  double end_time_;
  double weight_;
};

/// Gives unbroken spring bolts the forces of their present lengths.
void put_bolt_forces(const StandardScene& scene, Motion& motion);

/// Returns the rows of contacts, then of the fixed points: pushes and impacts of supported blocks include their
/// supports.
ContactRows rows_with_points(const StandardScene& scene, const UnknownsTable& q, const Touches& touches);

}  // namespace keyblock
