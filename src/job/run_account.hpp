// Keeps the account of a run, with results in a folder or in memory, and judges it at the end.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "base/archive.hpp"
#include "job/run_record.hpp"
#include "job/run_warnings.hpp"
#include "problem/output_plan.hpp"
#include "run/follow/drawn_joints.hpp"
#include "run/follow/epochs.hpp"
#include "run/follow/followed.hpp"
#include "run/follow/kept_histories.hpp"
#include "run/prepare.hpp"

namespace keyblock {

/// Record of a run that grows with every step, and the values behind its warnings: totals, rows of steps and of the
/// energy balance, histories, epochs.
class RunAccount {
 public:
  /// Takes in `record` the data known before the first step. Points of `histories` are measured points of the scene
  /// already. Keeps a reference to `prepared`. Throws InputError for a history of a missing part.
  RunAccount(const Prepared& prepared, RunRecord record, const std::vector<HistoryPlan>& histories, Place place);

  /// Take the reports of the run, in the order of an `Observer`.
  void add(const StepReport& report);
  void add(const LedgerRow& row);
  void add(const Stepper& stepper);  ///< the state at the start or after a step
  /// Takes the contacts of the next frame and sets their joints.
  void add(ContactFrames contacts, const Model& model);
  void add(const Frame& frame, const Model& model);
  const ContactFrames& contacts() const { return contacts_; }

  /// Saves or restores the account so far.
  void describe(Archive& archive);

  /// Adds the final warnings and the judgement to the record, whose outcome is set already.
  void judge(const Frame& first, const Frame& last);

  RunRecord& record() { return record_; }
  const RunRecord& record() const { return record_; }
  bool is_static() const { return watch_.is_static(); }
  const Followed& followed() const { return followed_; }
  /// Returns true if tables of histories have a row of this step.
  bool has_row(int step) const;
  /// Returns true if something is followed, but not with a row of this step.
  bool lacks_row(int step) const { return !followed_.is_empty() && !has_row(step); }
  /// Returns the followed values of the present state.
  const std::vector<FollowedValue>& values(const Stepper& stepper);
  /// Keeps the histories in memory too, for callers of the library.
  void keep_histories() { keeps_ = true; }
  const KeptHistories& histories() const { return kept_; }
  const std::shared_ptr<const DrawnJoints>& joints() const { return joints_; }
  /// Returns how often the bodies of the run have changed.
  int epoch(const Model& now) { return bodies_change_ ? epochs_.at(now) : 0; }

 private:
  const Prepared& prepared_;
  Place place_;
  RunRecord record_;
  StepWatch watch_;
  std::shared_ptr<const DrawnJoints> joints_;
  Followed followed_;
  std::vector<FollowedValue> values_;  ///< of the step `valued_`
  int valued_ = -1;
  bool keeps_ = false;
  KeptHistories kept_;
  bool bodies_change_;  ///< by stages or growing cracks
  Epochs epochs_;
  ContactFrames contacts_;
};

}  // namespace keyblock
