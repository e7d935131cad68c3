// Runs this program again as a child process, with limits and with its output in files.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/context.hpp"

namespace keyblock {

struct ChildLimits {
  int cpu_seconds = 0;       ///< 0: none
  int memory_mebibytes = 0;  ///< of address space; 0: none
};

struct ChildEnd {
  int exit_code = 0;             ///< 128 + the signal if one ended it
  bool ran_out_of_time = false;  ///< killed at the limit, or stopped there with its results written
  int signal = 0;                ///< that ended it; 0: it ended by itself
  bool was_stopped = false;      ///< requested to stop before its end
};

/// Runs this program with `arguments` until it ends. It has its own process group, so that Ctrl-C at the terminal does
/// not reach it. It ends when the calling thread does. If `stop` is stopped, it is requested to stop too. Throws
/// OutputError if it cannot be started.
ChildEnd run_child(const std::vector<std::string>& arguments, const ChildLimits& limits,
                   const std::filesystem::path& output, const std::filesystem::path& messages,
                   const Context* stop = nullptr);

}  // namespace keyblock
