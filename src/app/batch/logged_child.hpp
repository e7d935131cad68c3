// Runs this program again with its output in files next to its results, and explains its end.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/batch/child_process.hpp"

namespace keyblock {

/// Runs a child process with its output in NAME.out and its messages in NAME.log of the folder. Throws OutputError,
/// with the last error of the process, if it could not write its results: other jobs cannot write theirs either, and
/// this one is no row. `--resume` does it again.
ChildEnd run_logged(const std::vector<std::string>& arguments, const ChildLimits& limits,
                    const std::filesystem::path& folder, const std::string& name, const Context* stop = nullptr);

/// Returns true if the process ended because it was requested to: by this process, or by a signal that the whole job
/// got, such as that of Slurm. It has then no result.
bool has_been_stopped(const ChildEnd& end);

/// Returns the last line of the log with an error; empty without one.
std::string error_in(const std::filesystem::path& log);

/// Returns true if the process ended because its limit of memory was too small.
bool is_starved(const ChildEnd& end, const ChildLimits& limits);

/// Returns "SIGKILL", or "signal 40" for a signal without a name. Names the limit of memory, if there is one: libraries
/// such as HDF5 crash if they get no memory.
std::string signal_of(const ChildEnd& end, const ChildLimits& limits);

/// Explains the end of a process without a result: a limit, a signal, or its exit code and last error.
std::string why_it_ended(const ChildEnd& end, const ChildLimits& limits, const std::filesystem::path& log);

/// Makes the folder, without files of an earlier attempt. Throws OutputError.
std::filesystem::path empty_folder(const std::filesystem::path& folder);

}  // namespace keyblock
