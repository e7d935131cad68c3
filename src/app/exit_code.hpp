// Declares the exit codes of the program, each with one meaning.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace keyblock {

enum class ExitCode {
  ok = 0,
  check_failed = 1,       ///< it ran, but a check failed
  usage = 2,              ///< the command line
  unreadable = 3,         ///< input that cannot be read or used
  numerical_failure = 4,  ///< the computation could not continue; the state is saved
  limit = 5,              ///< a limit of processor time or memory ended it; results so far are saved
  stopped = 130,          ///< by the user
};

}  // namespace keyblock
