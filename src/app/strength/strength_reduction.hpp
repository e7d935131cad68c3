// What `fos` and `run --reduce-strength` share: the search, its tables and its pictures.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "api/plan.hpp"
#include "app/exit_code.hpp"

namespace keyblock {

struct ReductionOptions {
  std::string what;                      ///< joints, rock or both; empty: none
  ReductionAsked asked;                  ///< but for what
  std::optional<long long> trial_limit;  ///< linear systems; 0: none
  bool seeks_mesh_error = true;
  std::string folder;
  bool as_json = false;
  bool force = false;
};

/// `--from`, `--to`, `--to-within`, `--trial-limit`, `--exempt`, `--no-mesh-error`.
std::vector<CLI::Option*> add_reduction_options(CLI::App& options, ReductionOptions& chosen);

/// Searches, prints and writes; what the options leave open is taken from `case.json`. The profile is `standard` for
/// old files too, unless one is asked for: the search is one of statics. Throws UsageError for options that do not fit
/// and for a profile that `case.json` does not run, InputError for a case that cannot be reduced.
ExitCode reduce_strength(const AskedCase& asked, const ReductionOptions& options);

}  // namespace keyblock
