// Runs the built program as a user would, and measures it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <csignal>
#include <functional>
#include <string>
#include <vector>

namespace keyblock::support {

struct ProgramRun {
  int exit_code = -1;    ///< 128 + signal if it was killed
  std::string output;    ///< standard output
  std::string messages;  ///< standard error
  double cpu_seconds = 0;
  double peak_megabytes = 0;
};

/// Runs `keyblock ARGUMENTS…` in the current folder.
ProgramRun run_keyblock(const std::vector<std::string>& arguments);

/// Does the same, and sends `signal` as soon as `file` exists.
ProgramRun interrupt_keyblock(const std::vector<std::string>& arguments, const std::string& file, int signal = SIGINT);

/// Does the same, and calls `meanwhile` as soon as `file` exists.
ProgramRun run_keyblock(const std::vector<std::string>& arguments, const std::string& file,
                        const std::function<void()>& meanwhile);

/// Runs a script of the shell, in which $K is the program.
ProgramRun run_script(const std::string& script);

/// Does the same, and kills the script (SIGKILL) after so many seconds, if it still runs.
ProgramRun kill_keyblock(const std::vector<std::string>& arguments, double seconds);
/// Does the same, and kills the script (SIGKILL) as soon as `file` has that many lines.
ProgramRun kill_keyblock(const std::vector<std::string>& arguments, const std::string& file, int lines);

/// Returns a fresh empty folder below the temporary folder of the system.
std::string fresh_folder(const std::string& name);

}  // namespace keyblock::support
