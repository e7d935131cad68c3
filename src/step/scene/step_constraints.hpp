// Bolts and held points as forces of a step, beside those of touches.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "contact/rows/constraints.hpp"
#include "contact/solve/frictional_problem.hpp"
#include "step/scene/standard_scene.hpp"

namespace keyblock {

/// The springs among the bolts that are not broken, then the held points, each a pair of forces. A bolt is a spring
/// along its direction with the force f = pretension + stiffness × elongation; over a step it has λ = −((1−θ) f0 + θ
/// f1) ≥ −strength, with the weight θ of the elastic force, 1/2 for the mean of both ends that keeps its energy (Simo,
/// Tarnow & Wong 1992). A point is held in x and y where its motion wants it at the end of the step.
class StepConstraints {
 public:
  StepConstraints(const StandardScene& scene, const Motion& start, double time, double dt, double weight = 1);

  std::size_t count() const { return bolts_.size() + points_.size(); }
  std::size_t bolt_count() const { return bolts_.size(); }
  /// Forces at the start.
  Eigen::VectorXd remembered() const;

  /// Of all constraints, at q.
  ContactRows rows(const UnknownsTable& q) const;

  /// Length over force of the step, one a constraint; 0 for a point.
  double compliance(std::size_t constraint) const;
  ForceLaw law(std::size_t constraint) const;

  /// What would be left between the constraints and where they want to be at q without further force: 2i normal, 2i + 1
  /// across.
  Eigen::VectorXd gaps(const UnknownsTable& q) const;

  /// Force of a bolt after the step, its strength where it has broken.
  double at_end(std::size_t bolt, const Motion& end) const;

  /// Elongations of the bolts at q.
  Eigen::VectorXd elongation(const UnknownsTable& q) const;

  /// What the motion remembers after a step with these forces that ends at q; bolts at their strength are broken.
  ConstraintMemory memory(const Eigen::VectorXd& forces, const UnknownsTable& q) const;

 private:
  const StandardScene& scene_;
  const Motion& start_;
  std::vector<std::size_t> bolts_;
  const std::vector<CarriedPoint>& points_;
  double end_time_;
  double weight_;
};

/// Bolts at their pretension, points without force.
ConstraintMemory constraint_start(const StandardScene& scene);

/// Rows of touches, then of the held points: blocks that are held somewhere are pushed and struck with their holds.
ContactRows rows_with_points(const StandardScene& scene, const UnknownsTable& q, const Touches& touches);

}  // namespace keyblock
