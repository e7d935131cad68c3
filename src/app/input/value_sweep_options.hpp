// Declares the sweep over values of a case, for the command `sweep`.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/exit_code.hpp"
#include "app/input/case_options.hpp"

namespace keyblock {

struct ValueSweepOptions {
  CaseOptions given;
  std::vector<std::string> over;  ///< KEY=VALUES
  std::string design_file;        ///< rows as JSON
  std::size_t random = 0;         ///< number of random rows; 0: a grid
  std::uint64_t seed = 1;
  bool is_zipped = false;
  std::string joints;  ///< file with statistics of joints
  std::string out = "displacement";
  std::vector<std::string> histories;
  std::optional<double> within;
  std::string folder;
  int jobs = 0;  ///< at a time; 0: as many as there are processors
  int cpu_seconds = 0;
  int memory_mebibytes = 0;
  std::string shard;
  bool is_merged = false;
  int slurm = 0;     ///< number of shards of a script to print
  int parallel = 0;  ///< number of shards of a line to print
  bool is_resumed = false;
  bool force = false;
  bool as_json = false;
};

/// Runs the sweep, a shard of it, or writes the table of all shards. Throws UsageError, InputError,
/// std::invalid_argument.
ExitCode sweep_values(const ValueSweepOptions& options);  // batch/value_sweep.cpp

}  // namespace keyblock
