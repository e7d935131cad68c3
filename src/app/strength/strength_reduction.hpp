// Performs the search of `fos` and `run --reduce-strength`, and writes its tables and pictures. Theory:
// docs/theory/11-strength-reduction.md.
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
  ReductionAsked asked;                  ///< all except `what`
  std::optional<long long> trial_limit;  ///< linear solves; 0: none
  bool seeks_mesh_error = true;
  std::string folder;
  bool as_json = false;
  bool plan_only = false;  ///< print the plan as JSON, and make no trial
  bool force = false;
};

/// Adds `--from`, `--to`, `--to-within`, `--trial-limit`, `--exempt`, `--no-mesh-error`.
std::vector<CLI::Option*> add_reduction_options(CLI::App& options, ReductionOptions& chosen);

/// Searches, prints and writes; missing options are taken from `case.json`. The default profile is `standard`, also for
/// files of Shi's programs: the search is static. Throws UsageError for options that do not fit and for a profile that
/// `case.json` does not run. Throws InputError for a case that cannot be reduced.
ExitCode reduce_strength(const AskedCase& asked, const ReductionOptions& options);

}  // namespace keyblock
