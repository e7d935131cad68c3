// The forces of a step without impacts as a problem of complementarity: touches with their laws, bolts and held points.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "contact/solve/active_forces.hpp"
#include "step/scene/step_constraints.hpp"
#include "step/time/free_motion.hpp"
#include "step/time/smooth_solve.hpp"

namespace keyblock {

/// Rows, laws and right side about an estimate of the increments. Views what it is made from.
class SmoothContacts {
 public:
  SmoothContacts(const StandardScene& scene, const Motion& start, const Touches& touches,
                 const ForceTolerance& tolerance, double time, double dt, const StepRule& rule, const FreeMotion& free);

  bool is_empty() const { return touches_.empty() && constraints_.count() == 0; }
  std::size_t touch_count() const { return touches_.size(); }
  bool springs_stop() const { return scene_.settings.standard.impact == ImpactLaw::springs; }

  /// Laws as the bonds that still hold have them.
  void take_laws();
  /// Rows at mid-step, and the matrix of the answers of the bodies.
  void linearise(const UnknownsTable& estimate);
  /// What is left of the gaps at an estimate without further force.
  void set_right_side(const UnknownsTable& estimate);

  FrictionalProblem& problem() { return problem_; }
  const FrictionalProblem& problem() const { return problem_; }
  KeptSystem& kept() { return kept_; }
  const ContactRows& rows() const { return *rows_; }

  /// A bond that opens is gone, one that carries all it can without moving, because its neighbour holds, stays. Where
  /// none opens, faces sheared beyond their strength lose all theirs; contacts go on without cohesion (brittle joint).
  /// Whether any broke.
  bool break_bonds(const Eigen::VectorXd& forces);

  /// Forces of the step before, and those of an attempt with the first of the touches alone.
  Eigen::VectorXd remembered_forces() const;
  Eigen::VectorXd forces_of(const SmoothMotion& before) const;

  /// Hands over all that the step is to know of its contacts, at its end.
  void put_end(SmoothMotion& to) &&;

 private:
  void add_compliance(Eigen::Index row, double compliance);
  void add_laws();
  void follow_lines(const Eigen::VectorXd& compliance);
  void put_goal();
  bool has_proximal() const;
  bool follows_rate(std::size_t i) const;
  double tangential_scale(std::size_t i) const { return follows_way_[i] ? 1 : of_stretch(); }
  double normal_scale(std::size_t i) const { return springs_stop() ? 0 : follows_rate(i) ? of_stretch() : 1; }
  /// The tangential spring is stretched by dt times the velocity at the end of the step: a spring too stiff for the
  /// step then brings its point to rest, where the displacement of the step would turn the velocity over in each step.
  double of_stretch() const { return 1 / (free_.rate() * dt_); }
  Eigen::Index first_constraint() const { return static_cast<Eigen::Index>(2 * touches_.size()); }

  const StandardScene& scene_;
  const Motion& start_;
  const Touches& touches_;
  const FreeMotion& free_;
  ForceTolerance tolerance_;
  double dt_;
  bool may_follow_rates_;
  std::vector<bool> follows_way_;   ///< of each touch: friction is against the slip of the step
  std::vector<double> start_gaps_;  ///< of each touch
  Bonds bonds_;
  StepConstraints constraints_;
  std::vector<ContactLaw> laws_;
  std::vector<const ContactMemory*> memories_;  ///< of each touch; none of one that was open
  std::shared_ptr<ContactRows> rows_;
  FrictionalProblem problem_;
  Eigen::VectorXd line_compliance_;  ///< of springs that stop impacts, as the matrix has it
  KeptSystem kept_;                  ///< of `problem_` and its rows
};

}  // namespace keyblock
