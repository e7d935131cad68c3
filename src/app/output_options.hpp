// `--history` and `--contacts`: what a run follows and which contacts it writes, on top of what its case file says.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <utility>
#include <vector>

#include "problem/output_plan.hpp"

namespace keyblock {

struct OutputOptions {
  std::vector<std::string> histories;
  std::string contacts;  ///< empty: as the case says
};

/// `--history`, then `--contacts`.
std::pair<CLI::Option*, CLI::Option*> add_output_options(CLI::App& options, OutputOptions& chosen);

/// The plan of the case file with what the options ask for. Throws UsageError for an option that says nothing known.
OutputPlan outputs_asked(OutputPlan plan, const OutputOptions& options);

}  // namespace keyblock
