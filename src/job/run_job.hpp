// One run into its folder: begun or gone on with, stepped with checkpoints on the way, finished with its record.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "job/run_folder.hpp"
#include "job/run_report.hpp"
#include "job/run_warnings.hpp"
#include "job/saved_run.hpp"
#include "run/follow/followed.hpp"
#include "run/prepare.hpp"

namespace keyblock {

struct RunJobOptions {
  std::filesystem::path folder;
  Overwrite overwrite = Overwrite::no;
  Trace trace = Trace::no;
  double checkpoint_every = 0;  ///< seconds; 0: none but at the start and where the run is stopped
  Place place;                  ///< of the analysis, for what is said of the whole run
  OutputPlan outputs = {};      ///< points of histories are measured points of the scene
  std::string shown = {};       ///< in field.svg, as RunResults has it
  formats::MaterialNames names = {};
  formats::VtkCoding frames = formats::VtkCoding::raw;
  bool has_pictures = true;
};

class RunJob {
 public:
  /// `record` holds what is known before the first step: profile, inputs, warnings, timings, frames. Touches nothing on
  /// the disk; throws UsageError where results stand in the folder that may not be overwritten and for outputs that
  /// cannot be, InputError for a history of what is not there. Where `saved` is given, the folder is that of the run to
  /// go on with. Views `prepared`.
  RunJob(const Prepared& prepared, RunRecord record, RunRequest request, RunJobOptions options, Archive* saved);

  /// Makes the folder with what was asked, or takes up what the checkpoint holds. Throws UsageError, InputError.
  void open();
  /// Steps that the checkpoint holds; none of a run that begins.
  std::optional<int> steps_before() const;

  /// Tells `on_step` of each step. False where it was stopped before its first step: nothing is told then, and
  /// `--resume` begins again. Throws InputError, and leaves no folder that it made, where the start cannot be.
  bool run(const std::function<void(const StepReport&)>& on_step);

  /// Writes all results and the record, which it returns as JSON.
  std::string finish(const std::string& title, double seconds);

  const RunRecord& record() const { return record_; }

 private:
  Observer observer(const std::function<void(const StepReport&)>& on_step);
  void write_checkpoint(Stepper& stepper);
  RunTables tables(const LedgerScope& scope) const;
  void write_tables(const LedgerScope& scope);
  void judge();
  void follow(const Stepper& stepper);
  void choose_outputs();
  Warnings large_tables() const;
  Warnings remarks_on_outputs() const;

  const Prepared& prepared_;
  RunRecord record_;
  RunRequest request_;
  RunJobOptions options_;
  Archive* saved_;
  RunFolder folder_;
  StepWatch watch_;
  DrawnJoints joints_;
  Followed followed_;
  const Stepper* stepping_ = nullptr;  ///< the run is in, once a state of it was told
  History history_;
  CheckpointClock clock_;
  std::chrono::steady_clock::time_point tables_due_;
  std::unique_ptr<Stepper> stepper_;               ///< restored; none of a run that begins
  FieldFrame field_;                               ///< of the frame that comes next
  ContactFrames contacts_;                         ///< likewise
  std::vector<std::vector<int>> joints_of_edges_;  ///< of the last frame, as `report::RunPicture` has them
};

}  // namespace keyblock
