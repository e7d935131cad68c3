// Passes each report to the record and to those that watch the run.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/run_account.hpp"

#include <utility>

#include "job/run_doubts.hpp"
#include "result/describe.hpp"

namespace keyblock {

RunAccount::RunAccount(const Prepared& prepared, RunRecord record, const std::vector<HistoryPlan>& histories,
                       Place place)
    : prepared_(prepared),
      place_(std::move(place)),
      record_(std::move(record)),
      watch_(prepared),
      joints_(std::make_shared<const DrawnJoints>(prepared.scene.model, prepared.joint_lines)),
      followed_(histories, prepared.scene, *joints_, record_.units),
      bodies_change_(prepared.scene.next != nullptr || prepared.scene.growth != nullptr) {
  const int stride = stride_of(prepared.scene.settings.step_count);
  record_.steps = StepRows(stride);
  record_.ledger = LedgerRows(stride);
  record_.warnings = joined(record_.warnings, followed_.of_distant_pairs());
}

void RunAccount::add(const StepReport& report) {
  record_.totals.add(report);
  record_.steps.add(report);
  watch_.add(report);
}

void RunAccount::add(const LedgerRow& row) {
  record_.ledger_sums.add(row);
  record_.ledger.add(row);
  watch_.blocks().add(row);
}

void RunAccount::add(const Stepper& stepper) {
  watch_.blocks().add(stepper);
  if (bodies_change_) epochs_.at(stepper.model());
  if (keeps_ && has_row(stepper.state().step)) kept_.add(stepper.state().time, values(stepper));
}

void RunAccount::add(ContactFrames contacts, const Model& model) {
  contacts_ = std::move(contacts);
  joints_->name(contacts_, model);
}

void RunAccount::add(const Frame& frame, const Model& model) {
  watch_.blocks().add(frame, contacts_, model, prepared_.scene.settings);
}

void RunAccount::describe(Archive& archive) {
  const auto describe_step = [&](StepReport& report) { keyblock::describe(archive, report); };
  archive.group("totals", [&] { keyblock::describe(archive, record_.totals); });
  archive.group("steps", [&] { record_.steps.describe(archive, describe_step); });
  archive.list("traced", record_.traced, describe_step);
  archive.group("watch", [&] { watch_.describe(archive); });
  followed_.describe(archive);
  archive.group("kept", [&] { kept_.describe(archive); });
  archive.group("epochs", [&] { epochs_.describe(archive); });
  archive.group("ledger_sums", [&] { keyblock::describe(archive, record_.ledger_sums); });
  archive.group("ledger",
                [&] { record_.ledger.describe(archive, [&](LedgerRow& row) { keyblock::describe(archive, row); }); });
}

void RunAccount::judge(const Frame& first, const Frame& last) {
  record_.warnings = joined(record_.warnings, watch_.warnings(place_));
  record_.warnings = joined(record_.warnings, followed_.of_nothing());
  record_.extremes = extremes_of(first, last, record_.outcome.field);
  record_.plastic = plastic_extremes_of(last);
  keyblock::judge(record_, prepared_, watch_, first, last, place_);
}

bool RunAccount::has_row(int step) const {
  const int last = prepared_.scene.settings.step_count;
  return !followed_.is_empty() && (step % stride_of(last) == 0 || step == last);
}

const std::vector<FollowedValue>& RunAccount::values(const Stepper& stepper) {
  const int step = stepper.state().step;
  if (std::exchange(valued_, step) != step) values_ = followed_.values(stepper, *joints_);
  return values_;
}

}  // namespace keyblock
