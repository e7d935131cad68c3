// Saves the data of a checkpoint other than the stepper: the request of the run, and its reports so far.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "base/archive.hpp"
#include "job/run_account.hpp"
#include "job/run_folder.hpp"
#include "result/history.hpp"

namespace keyblock {

/// Command line of a run, and the files and settings that it led to.
struct RunRequest {
  std::string program;         ///< `this_program` when the run began
  std::string folder;          ///< of the results, its full path
  std::string working_folder;  ///< base of relative file names
  std::vector<std::string> files;
  std::string profile;
  std::vector<std::string> sets;  ///< key=value
  int record_every = 1;
  bool has_trace = false;
  std::vector<std::string> read;            ///< every file read
  std::vector<std::string> digests;         ///< SHA-256 of each file read
  std::vector<std::string> settings;        ///< all, key=value
  std::vector<std::string> histories = {};  ///< as on the command line
  std::string contacts = {};                ///< as on the command line
  std::string field = {};                   ///< as on the command line
  std::string unit = {};                    ///< of the drawing, as on the command line
  double join = 0;                          ///< as on the command line
  std::string frames = {};                  ///< their coding, as on the command line
  bool has_pictures = true;
  bool has_page = false;
  double checkpoint_every = 0;           ///< seconds
  std::vector<std::string> values = {};  ///< POINTER=VALUE, as on the command line
};

void describe(Archive& archive, RunRequest& request);

/// Returns version and build of the running program or library: another build may lay out its state differently, or
/// round differently.
std::string this_program();

/// Saves and restores the reports of the run: its account, rows of history, and frames.
void describe_told(Archive& archive, RunFolder& folder, History& history, RunAccount& account);

/// Returns the checkpoint written at the start: the group request alone. A run resumed from it begins again.
std::string bytes_before_steps(RunRequest& request);

/// Returns true if the checkpoint holds steps after the request.
bool holds_steps(const Archive& saved);

/// Returns the whole checkpoint: groups request, records, folder, stepper.
std::string saved_bytes(RunRequest& request, RunFolder& folder, History& history, RunAccount& account,
                        Stepper& stepper);

/// Decides when the next checkpoint is due: after a number of seconds, or only when the run is stopped.
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

/// Reads the checkpoint of a run's folder; `file` is its full path. Throws UsageError if it is missing, InputError if
/// it cannot be used.
Archive read_checkpoint(const std::filesystem::path& file);

/// Throws InputError if the checkpoint belongs to another folder whose run still exists. A moved folder is accepted.
void require_own(const std::filesystem::path& checkpoint, const RunRequest& saved);

/// Throws InputError if a file, the program or a setting differs from that of the checkpoint.
void require_same(const std::filesystem::path& checkpoint, const RunRequest& saved, const RunRequest& now);

}  // namespace keyblock
