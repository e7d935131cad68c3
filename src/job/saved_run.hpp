// What a checkpoint holds beside the stepper: what the run was asked to do, and what it has told so far.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "base/archive.hpp"
#include "job/run_folder.hpp"
#include "job/run_report.hpp"
#include "job/run_warnings.hpp"
#include "result/history.hpp"
#include "run/follow/followed.hpp"

namespace keyblock {

/// A run's command line, and what it found behind it.
struct RunRequest {
  std::string program;         ///< `this_program` of the one that began the run
  std::string folder;          ///< of the results, its full path
  std::string working_folder;  ///< that names of files are taken from
  std::vector<std::string> files;
  std::string profile;
  std::vector<std::string> sets;  ///< key=value
  int record_every = 1;
  bool has_trace = false;
  std::vector<std::string> read;            ///< every file read
  std::vector<std::string> digests;         ///< SHA-256 of those
  std::vector<std::string> settings;        ///< all, key=value
  std::vector<std::string> histories = {};  ///< as the command line has them
  std::string contacts = {};                ///< likewise
  std::string field = {};                   ///< likewise
  std::string unit = {};                    ///< of the drawing, likewise
  double join = 0;                          ///< likewise
  std::string frames = {};                  ///< how they are coded, likewise
  bool has_pictures = true;
};

void describe(Archive& archive, RunRequest& request);

/// Version and build of the program or library that runs: another build may lay out its state otherwise, or round
/// otherwise.
std::string this_program();

/// What the run has told: rows of history, steps and ledger, sums of them, warnings of steps, what is followed, and its
/// frames.
void describe_told(Archive& archive, RunFolder& folder, History& history, RunRecord& record, StepWatch& watch,
                   Followed& followed);

/// What a run leaves at its start: the group request alone. Resumed from it, the run begins again.
std::string bytes_before_steps(RunRequest& request);

/// Whether there are steps to go on from behind the request.
bool holds_steps(const Archive& saved);

/// The whole checkpoint: groups request, records, folder, stepper.
std::string saved_bytes(RunRequest& request, RunFolder& folder, History& history, RunRecord& record, StepWatch& watch,
                        Followed& followed, Stepper& stepper);

/// Says when the next checkpoint is due: every so many seconds, or only when the run is stopped.
class CheckpointClock {
 public:
  explicit CheckpointClock(double every) : every_(every) {}
  bool is_due() const { return every_ > 0 && seconds_since() >= (is_first_ ? std::min(kFirst, every_) : every_); }
  void written() {
    last_ = std::chrono::steady_clock::now();
    is_first_ = false;
  }

 private:
  double seconds_since() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - last_).count();
  }

  static constexpr double kFirst = 3;  ///< seconds: most runs are short

  double every_;
  bool is_first_ = true;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// The checkpoint of a run's folder, by its full path. Throws UsageError where there is none, InputError where it
/// cannot be used.
Archive read_checkpoint(const std::filesystem::path& file);

/// Throws InputError where the checkpoint is that of another folder, whose run still stands there: not where the folder
/// was moved.
void require_own(const std::filesystem::path& checkpoint, const RunRequest& saved);

/// Throws InputError where a file, the program or a setting is not that of the checkpoint any more.
void require_same(const std::filesystem::path& checkpoint, const RunRequest& saved, const RunRequest& now);

}  // namespace keyblock
