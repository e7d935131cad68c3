// Runs one case into its folder: starts or resumes it, steps it with checkpoints, writes its record at the end.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "job/run_account.hpp"
#include "job/run_folder.hpp"
#include "job/saved_run.hpp"
#include "run/follow/stop_criterion.hpp"
#include "run/prepare.hpp"

namespace keyblock {

struct RunJobOptions {
  std::filesystem::path folder;
  Overwrite overwrite = Overwrite::no;
  Trace trace = Trace::no;
  double checkpoint_every = 0;  ///< seconds; 0: only at the start and if the run is stopped
  Place place;                  ///< of the analysis, for warnings about the whole run
  OutputPlan outputs = {};      ///< points of histories are measured points of the scene
  std::string shown = {};       ///< in field.svg, as in RunResults
  formats::MaterialNames names = {};
  formats::VtkCoding frames = formats::VtkCoding::automatic;
  bool has_pictures = true;
  bool has_page = false;  ///< write page.html at the end
  std::optional<StopCriterion> stop_when = {};
};

/// Functions that a run calls. Any may be empty.
struct RunCalls {
  std::function<void(const StepReport&)> on_step = {};  ///< after every step
  std::function<void(const Stepper&)> on_state = {};    ///< at the start and after every step
};

class RunJob {
 public:
  /// Takes in `record` the data known before the first step: profile, inputs, warnings, timings, frames. Changes
  /// nothing on the disk. Throws UsageError for impossible outputs, or if results in the folder may not be overwritten.
  /// Throws InputError for a history of a missing part. If `saved` is given, the folder is that of the run to resume.
  /// Keeps a reference to `prepared`.
  RunJob(const Prepared& prepared, RunRecord record, RunRequest request, RunJobOptions options, Archive* saved);

  /// Makes the folder with the request, or restores the checkpoint. Throws UsageError, InputError.
  void open();
  /// Returns the number of steps in the checkpoint; nothing for a new run.
  std::optional<int> steps_before() const { return steps_before_; }

  /// Calls `on_step` for each step. Returns false if the run was stopped before its first step: there is no report
  /// then, and `--resume` begins again. Throws InputError if the run cannot start; a folder that it made is removed.
  bool run(const std::function<void(const StepReport&)>& on_step);

  /// The same in steps: `start`, which throws StopRequested, `step` until false, `end`.
  void start(RunCalls calls);
  bool step();
  void end();
  void end_early(const std::string& why);  ///< with a checkpoint; `why` becomes `ended_early` in run.json
  std::shared_ptr<Stepper> stepper() const { return stepper_; }

  /// Writes all results and the record; returns the record as JSON.
  std::string finish(const std::string& title, double seconds);

  const std::shared_ptr<RunAccount>& account() const { return account_; }

 private:
  Observer observer();
  template <class Work>
  void taking_back(const Work& work);
  void write_checkpoint(Stepper& stepper);  ///< if it is due
  void save(Stepper& stepper);
  void tell_caller();
  void write_tables(const LedgerScope& scope);
  void stop_if_met(const Stepper& stepper);
  void choose_outputs();

  const Prepared& prepared_;
  RunRequest request_;
  RunJobOptions options_;
  Archive* saved_;
  RunFolder folder_;
  std::shared_ptr<RunAccount> account_;
  std::string criterion_met_;  ///< in words; empty before that
  History history_;
  CheckpointClock clock_;
  std::chrono::steady_clock::time_point tables_due_;
  std::shared_ptr<Stepper> stepper_;  ///< null in a new run, before its start
  std::optional<int> steps_before_;
  RunCalls calls_;
  StepReport last_;
  Observer told_;
  std::optional<StepLoop> loop_;
  FieldFrame field_;                               ///< of the next frame
  std::vector<std::vector<int>> joints_of_edges_;  ///< of the last frame, in the form of `report::RunPicture`
};

}  // namespace keyblock
