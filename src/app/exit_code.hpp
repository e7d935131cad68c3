// Declares the exit codes of the program, each with one meaning.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace keyblock {

enum class ExitCode {
  ok = 0,
  check_failed = 1,       ///< it ran, but a check failed
  usage = 2,              ///< the command line
  unreadable = 3,         ///< input that cannot be read or used
  numerical_failure = 4,  ///< the computation could not continue, its state is saved; or results could not be written
  limit = 5,              ///< a limit of processor time or memory ended it; results so far are saved
  stopped = 130,          ///< by the user
};

/// Argument 0 of a process that `batch` or `sweep` starts. It ends with kCannotWrite where others end with
/// numerical_failure: a full disk is no result of the job.
inline constexpr const char* kJobName = "keyblock-job";
inline constexpr int kCannotWrite = 6;

}  // namespace keyblock
