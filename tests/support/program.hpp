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

/// `keyblock ARGUMENTS…`, in the current folder.
ProgramRun run_keyblock(const std::vector<std::string>& arguments);

/// The same, sent `signal` as soon as `file` exists.
ProgramRun interrupt_keyblock(const std::vector<std::string>& arguments, const std::string& file, int signal = SIGINT);

/// The same; `meanwhile` is called as soon as `file` exists.
ProgramRun run_keyblock(const std::vector<std::string>& arguments, const std::string& file,
                        const std::function<void()>& meanwhile);

/// A script of the shell, in which $K is the program.
ProgramRun run_script(const std::string& script);

/// The same, killed (SIGKILL) after so many seconds, if it still runs.
ProgramRun kill_keyblock(const std::vector<std::string>& arguments, double seconds);
/// The same, killed (SIGKILL) as soon as `file` has that many lines.
ProgramRun kill_keyblock(const std::vector<std::string>& arguments, const std::string& file, int lines);

/// A fresh empty folder below the system's temporary one.
std::string fresh_folder(const std::string& name);

}  // namespace keyblock::support
