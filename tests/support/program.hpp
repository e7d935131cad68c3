// Runs the built program as a user would, and measures it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace keyblock::testing {

struct ProgramRun {
  int exit_code = -1;    ///< 128 + signal if it was killed
  std::string output;    ///< standard output
  std::string messages;  ///< standard error
  double cpu_seconds = 0;
  double peak_megabytes = 0;
};

/// `keyblock ARGUMENTS…`, in the current folder. `signal_after_ms` sends SIGINT after that time, 0 never.
ProgramRun run_keyblock(const std::vector<std::string>& arguments, int signal_after_ms = 0);

/// A fresh empty folder below the system's temporary one.
std::string fresh_folder(const std::string& name);

}  // namespace keyblock::testing
