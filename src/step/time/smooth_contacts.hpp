// Sets up the contact forces of a step without impacts as a complementarity problem of contacts, bolts and fixed
// points. Theory: docs/theory/05-frictional-contact.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "contact/solve/active_forces.hpp"
#include "step/scene/step_constraints.hpp"
#include "step/time/free_motion.hpp"
#include "step/time/smooth_motion.hpp"

namespace keyblock {

/// Rows, laws and right-hand side about an estimate of the increments. Keeps references to its arguments.
class SmoothContacts {
 public:
  SmoothContacts(const StandardScene& scene, const Motion& start, const Touches& touches,
                 const ForceTolerance& tolerance, double time, double dt, const StepRule& rule, const FreeMotion& free);

  bool is_empty() const { return touches_.empty() && constraints_.count() == 0; }
  std::size_t touch_count() const { return touches_.size(); }
  bool springs_stop() const { return scene_.settings.standard.impact == ImpactLaw::springs; }

  /// Updates the laws to the unbroken bonds.
  void take_laws();
  /// Computes the rows at mid-step, and the matrix of the bodies' responses.
  void linearise(const UnknownsTable& estimate);
  /// Computes the gaps that remain at an estimate without further force.
  void set_right_side(const UnknownsTable& estimate);

  FrictionalProblem& problem() { return problem_; }
  const FrictionalProblem& problem() const { return problem_; }
  KeptSystem& kept() { return kept_; }
  const ContactRows& rows() const { return *rows_; }

  /// Returns bonds that open. A bond at its limit that does not move, because its neighbour holds, stays. If no bond
  /// opens, returns all bonds of the faces that are sheared or bent beyond their strength (brittle joint).
  std::vector<Facing> overloaded_bonds(const Eigen::VectorXd& forces) const;
  /// Breaks them. Returns true if there were any.
  bool break_bonds(const Eigen::VectorXd& forces);

  /// Returns the forces of the last step. `forces_of`: those of an attempt with only the first contacts.
  Eigen::VectorXd remembered_forces() const;
  Eigen::VectorXd forces_of(const SmoothMotion& before) const;

  /// Moves all data on contacts that the step needs at its end into `to`.
  void put_end(SmoothMotion& to) &&;

 private:
  void add_compliance(Eigen::Index row, double compliance);
  void add_laws();
  void follow_lines(const Eigen::VectorXd& compliance);
  void put_goal();
  void put_shares();
  bool has_proximal() const;
  bool follows_rate(std::size_t i) const;
  double tangential_scale(std::size_t i) const { return follows_way_[i] ? 1 : of_stretch(); }
  double normal_scale(std::size_t i) const { return springs_stop() ? 0 : follows_rate(i) ? of_stretch() : 1; }
  /// Returns the factor from stretch to velocity. The tangential spring is stretched by dt times the end velocity, so
  /// that a spring too stiff for the step brings its point to rest. The displacement of the step would reverse the
  /// velocity in each step.
  double of_stretch() const { return 1 / (free_.rate() * dt_); }
  Eigen::Index first_constraint() const { return static_cast<Eigen::Index>(2 * touches_.size()); }

  const StandardScene& scene_;
  const Motion& start_;
  const Touches& touches_;
  const FreeMotion& free_;
  ForceTolerance tolerance_;
  double dt_;
  bool may_follow_rates_;
  std::vector<bool> follows_way_;   ///< per contact: friction opposes the slip of the step
  std::vector<double> start_gaps_;  ///< per contact
  double greatest_before_ = 0;      ///< greatest force of the last step
  Bonds bonds_;
  StepConstraints constraints_;
  std::vector<ContactLaw> laws_;
  std::vector<const ContactMemory*> memories_;  ///< per contact; null for one that was open
  std::shared_ptr<ContactRows> rows_;
  FrictionalProblem problem_;
  Eigen::VectorXd line_compliance_;  ///< of springs that stop impacts, as in the matrix
  KeptSystem kept_;                  ///< of `problem_` and its rows
};

}  // namespace keyblock
