// `--history`, `--contacts` and `--field`: what a run follows, which contacts it writes and what its picture of a field
// shows, on top of what its case file says.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <array>
#include <string>
#include <vector>

#include "problem/output_plan.hpp"

namespace keyblock {

struct OutputOptions {
  std::vector<std::string> histories;
  std::string contacts;  ///< empty: as the case says
  std::string field;     ///< empty: the stress that varies most
};

/// `--history`, `--contacts`, `--field`.
std::array<CLI::Option*, 3> add_output_options(CLI::App& options, OutputOptions& chosen);

/// The plan of the case file with what the options ask for. Throws UsageError for an option that says nothing known.
OutputPlan outputs_asked(OutputPlan plan, const OutputOptions& options);

}  // namespace keyblock
