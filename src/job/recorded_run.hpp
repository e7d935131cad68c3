// Runs a case with its results in a folder, from the start or from a checkpoint: what `keyblock run` does and prints
// about, and what the library records.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "api/plan.hpp"
#include "base/archive.hpp"
#include "job/folder/outputs_asked.hpp"
#include "job/run_job.hpp"

namespace keyblock {

struct RecordingOptions {
  std::string folder;
  Overwrite overwrite = Overwrite::no;
  Trace trace = Trace::no;
  double checkpoint_every = 30;  ///< seconds; 0: none but at the start and if the run is stopped
  int record_every = 0;          ///< steps per frame; 0: as the case says, at most `kMostFrames` frames
  OutputOptions outputs = {};
};

/// Not movable: the run refers to the plan that it holds.
class RecordedRun {
 public:
  /// Touches nothing on the disk. Throws as `opened`, `planned` and RunJob; UsageError if an input file lies in the
  /// folder of the results.
  RecordedRun(const AskedCase& asked, const RecordingOptions& options);
  /// The same of a case that was read before.
  RecordedRun(OpenCase read, const RecordingOptions& options);

  /// The run that was interrupted in `folder`, with what it was asked at first. Relative paths of its files count from
  /// the folder in which it began (Context::use_folder). Throws UsageError if there is nothing to resume, InputError
  /// for a checkpoint that does not fit the files, the settings or this build.
  RecordedRun(const std::string& folder, double checkpoint_every);

  RecordedRun(const RecordedRun&) = delete;
  RecordedRun& operator=(const RecordedRun&) = delete;

  /// Makes the folder, or takes up the checkpoint in it. Throws UsageError, InputError.
  void open() { job_->open(); }
  /// Steps that the checkpoint holds; none of a run that begins.
  std::optional<int> steps_before() const { return job_->steps_before(); }
  /// False if it was stopped before its first step: `finish` may not be called then.
  bool run(const std::function<void(const StepReport&)>& on_step) { return job_->run(on_step); }
  /// Writes all results. Returns run.json.
  std::string finish();

  const std::string& first_file() const { return read_.files.front(); }
  const std::string& folder() const { return options_.folder; }
  const Prepared& prepared() const { return plan_.prepared; }
  const RunRecord& record() const { return job_->record(); }

 private:
  using Time = std::chrono::steady_clock::time_point;
  /// What a run begins with.
  struct Beginning {
    Time at = std::chrono::steady_clock::now();
    RecordingOptions options;
    OpenCase read;
    std::optional<RunRequest> request = {};    ///< saved
    std::unique_ptr<Archive> checkpoint = {};  ///< its request already taken
  };
  static Beginning saved_in(const std::string& folder, double checkpoint_every);
  explicit RecordedRun(Beginning beginning);
  double lap();

  Time last_;  ///< lap
  RecordingOptions options_;
  OpenCase read_;
  PlannedCase plan_;
  std::string title_;
  std::unique_ptr<Archive> checkpoint_;
  std::unique_ptr<RunJob> job_;
};

}  // namespace keyblock
