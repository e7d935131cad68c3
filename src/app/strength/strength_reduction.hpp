// What `fos` and `run --reduce-strength` share: the search, its tables and its pictures.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/exit_code.hpp"
#include "formats/case.hpp"
#include "settings/settings_table.hpp"

namespace keyblock {

struct ReductionOptions {
  std::string what;  ///< joints, rock or both; empty: none
  std::optional<double> from;
  std::optional<double> to;
  std::optional<double> within;
  std::optional<long long> trial_limit;  ///< linear systems; 0: none
  std::vector<std::string> exempt;       ///< as `study::exempt_of` reads them
  bool seeks_mesh_error = true;
  std::string folder;
  bool as_json = false;
  bool force = false;
};

/// `--from`, `--to`, `--to-within`, `--trial-limit`, `--exempt`, `--no-mesh-error`.
std::vector<CLI::Option*> add_reduction_options(CLI::App& options, ReductionOptions& chosen);

/// The case as it was read. `folder`: files that overrides name lie there.
struct ReducedCase {
  std::string name;
  std::vector<std::string> files;
  formats::Case input;
  std::filesystem::path folder;
  std::string profile;
  std::vector<Override> overrides;
};

/// The profile asked for or that of the case file; else `standard`, of old files too: the search is one of statics.
std::string profile_of_reduction(const Problem& problem, const std::string& asked);

/// Searches, prints and writes. Throws UsageError for options that do not fit, InputError for a case that cannot be
/// reduced.
ExitCode reduce_strength(const ReducedCase& chosen, const ReductionOptions& options);

}  // namespace keyblock
