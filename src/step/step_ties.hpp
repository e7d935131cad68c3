// Bolts and held points as forces of a step, beside those of touches.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "contact/frictional_problem.hpp"
#include "contact/ties.hpp"
#include "step/standard_scene.hpp"

namespace keyblock {

/// The springs among the bolts that are not broken, then the held points, each a pair of forces. A bolt is a spring along its direction,
/// λ = −(pretension + stiffness × elongation) ≥ −strength; a point is held in x and y where its motion wants it at the end of the
/// step.
class StepTies {
 public:
  StepTies(const StandardScene& scene, const Motion& start, double time, double dt);

  std::size_t count() const { return bolts_.size() + points_.size(); }
  std::size_t bolt_count() const { return bolts_.size(); }
  /// Forces of the last step.
  Eigen::VectorXd remembered() const;

  /// Of all ties, at q.
  ContactRows rows(const UnknownsTable& q) const;

  /// Length over force, one a tie; 0 for a point.
  double compliance(std::size_t tie) const;
  ForceLaw law(std::size_t tie) const;

  /// What would be left between the ties and where they want to be at q without further force: 2i normal, 2i + 1 across.
  Eigen::VectorXd gaps(const UnknownsTable& q) const;

  /// Elongations of the bolts at q.
  Eigen::VectorXd elongation(const UnknownsTable& q) const;

  /// What the motion remembers of these forces; bolts at their strength are broken.
  TieMemory memory(const Eigen::VectorXd& forces) const;

 private:
  const StandardScene& scene_;
  const Motion& start_;
  std::vector<std::size_t> bolts_;
  const std::vector<CarriedPoint>& points_;
  double end_time_;
};

/// Bolts at their pretension, points without force.
TieMemory tie_start(const StandardScene& scene);

/// Rows of touches, then of the held points: blocks that are held somewhere are pushed and struck with their holds.
ContactRows rows_with_points(const StandardScene& scene, const UnknownsTable& q, const Touches& touches);

}  // namespace keyblock
