// Prints scripts that run the shards of a command under Slurm or GNU parallel.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace keyblock {

/// Returns the words of the command line of this process, without options that print scripts.
std::vector<std::string> own_command();

/// Returns an array script for `sbatch`: one task per shard. It ends well if jobs failed, because they are rows of the
/// table. A task that was stopped or reached its time is put into the queue again, and resumes from its checkpoints.
std::string slurm_script(const std::vector<std::string>& command, int shards);

/// Returns one line for a shell: all shards by GNU parallel, then the table.
std::string parallel_line(const std::vector<std::string>& command, int shards);

}  // namespace keyblock
