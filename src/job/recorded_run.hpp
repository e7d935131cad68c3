// Runs a case and writes its results into a folder, from the start or from a checkpoint. `keyblock run` and the library
// use it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "api/plan.hpp"
#include "base/archive.hpp"
#include "job/folder/outputs_asked.hpp"
#include "job/run_job.hpp"

namespace keyblock {

struct RecordingOptions {
  std::string folder;
  Overwrite overwrite = Overwrite::no;
  Trace trace = Trace::no;
  double checkpoint_every = 30;  ///< seconds; 0: only at the start and if the run is stopped
  int record_every = 0;          ///< steps per frame; 0: as the case requests, at most `kMostFrames` frames
  OutputOptions outputs = {};
  std::string stop_when = {};  ///< in the form that `stop_criterion_of` reads; empty: at the last step
};

/// Returns what the numbers of a study are of: `units`, where the case has them, and `inputs`.
nlohmann::ordered_json origin_json(const Units& units, const std::vector<formats::FileReading>& readings,
                                   const ConfiguredCase& made);

/// Run of a case with its results in a folder. It cannot be moved: the run refers to the plan that it owns.
class RecordedRun {
 public:
  /// Changes nothing on the disk. Throws like `opened`, `planned` and RunJob; UsageError if an input file lies in the
  /// folder of the results.
  RecordedRun(const AskedCase& asked, const RecordingOptions& options);
  /// Does the same for a case that was read before.
  RecordedRun(OpenCase read, const RecordingOptions& options);

  /// Resumes the run that was interrupted in `folder`, with its first request; `checkpoint_every` replaces that of the
  /// request. Relative paths of its files count from the folder in which it began (Context::use_folder). Throws
  /// UsageError if there is nothing to resume. Throws InputError for a checkpoint that does not fit the files, the
  /// settings or this build.
  explicit RecordedRun(const std::string& folder, std::optional<double> checkpoint_every = {});

  RecordedRun(const RecordedRun&) = delete;
  RecordedRun& operator=(const RecordedRun&) = delete;

  /// Makes the folder, or restores the checkpoint in it. Throws UsageError, InputError.
  void open() { job_->open(); }
  /// Returns the number of steps in the checkpoint; nothing for a new run.
  std::optional<int> steps_before() const { return job_->steps_before(); }
  /// Returns false if the run was stopped before its first step: `finish` may not be called then.
  bool run(const std::function<void(const StepReport&)>& on_step) { return job_->run(on_step); }
  /// Do the same step by step, as in RunJob.
  void start(RunCalls calls) { job_->start(std::move(calls)); }
  bool step() { return job_->step(); }
  void end() { job_->end(); }
  void end_early(const std::string& why) { job_->end_early(why); }
  std::shared_ptr<Stepper> stepper() const { return job_->stepper(); }
  /// Writes all results. Returns run.json.
  std::string finish();

  const OpenCase& read() const { return read_; }
  const std::string& first_file() const { return read_.files.front(); }
  const std::string& folder() const { return options_.folder; }
  const std::shared_ptr<const PlannedCase>& plan() const { return plan_; }
  const Prepared& prepared() const { return plan_->prepared; }
  const std::shared_ptr<RunAccount>& account() const { return job_->account(); }
  const RunRecord& record() const { return account()->record(); }

 private:
  using Time = std::chrono::steady_clock::time_point;
  /// State from which a run begins.
  struct Beginning {
    Time at = std::chrono::steady_clock::now();
    RecordingOptions options;
    OpenCase read;
    std::optional<RunRequest> request = {};    ///< saved
    std::unique_ptr<Archive> checkpoint = {};  ///< its request is already restored
  };
  static Beginning saved_in(const std::string& folder, std::optional<double> checkpoint_every);
  explicit RecordedRun(Beginning beginning);
  double lap();

  Time last_;  ///< lap
  RecordingOptions options_;
  OpenCase read_;
  std::shared_ptr<const PlannedCase> plan_;
  std::string title_;
  std::unique_ptr<Archive> checkpoint_;
  std::unique_ptr<RunJob> job_;
};

}  // namespace keyblock
