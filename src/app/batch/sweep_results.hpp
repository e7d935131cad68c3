// Writes and prints the table of a sweep.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/batch/sweep_columns.hpp"
#include "app/exit_code.hpp"
#include "app/input/value_sweep_options.hpp"
#include "study/sweep/sweep_table.hpp"

namespace keyblock {

struct SweepOrigin {
  std::filesystem::path folder;
  std::string title;            ///< of the picture
  nlohmann::ordered_json json;  ///< program, command and inputs, for sweep.json
};

/// Writes table.csv, columns.csv, times.csv, sweep.svg, and sweep.json with their checksums.
void write_sweep(const SweepOrigin& origin, const study::SweepTable& table, const std::vector<SweepColumn>& columns);

/// Returns the table as JSON, with the units of its columns.
std::string sweep_json(const study::SweepTable& table, const std::vector<SweepColumn>& columns);

/// Prints the table and the number of each verdict. Returns check_failed unless all runs finished.
ExitCode print_sweep(const ValueSweepOptions& options, const study::SweepTable& table,
                     const std::vector<SweepColumn>& columns);

/// Throws UsageError if table.csv in the folder has runs that are not among `jobs`.
void require_no_larger_table(const std::filesystem::path& folder, const std::vector<std::string>& jobs);

/// Returns true if the folder has a table, a picture or a record by a name that sweeps use.
bool has_files_of_sweep(const std::filesystem::path& folder);

/// Removes the results of an earlier sweep, and nothing else. Throws UsageError if a journal is not one of a sweep.
void remove_sweep(const std::filesystem::path& folder);

}  // namespace keyblock
