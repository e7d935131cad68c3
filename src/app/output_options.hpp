// `--history`, `--contacts`, `--field`, `--frames` and `--no-pictures`: what a run follows, which contacts it writes,
// what its pictures show, and how its frames are coded, on top of what its case file says.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <array>
#include <string>
#include <vector>

#include "formats/views/vtk_file.hpp"
#include "problem/output_plan.hpp"

namespace keyblock {

struct OutputOptions {
  std::vector<std::string> histories;
  std::string contacts;  ///< empty: as the case says
  std::string field;     ///< empty: the stress that varies most
  std::string frames = formats::vtk_coding_names().front();
  bool has_pictures = true;
};

/// `--history`, `--contacts`, `--field`, `--frames`, `--no-pictures`.
std::array<CLI::Option*, 5> add_output_options(CLI::App& options, OutputOptions& chosen);

/// The plan of the case file with what the options ask for. Throws UsageError for an option that says nothing known.
OutputPlan outputs_asked(OutputPlan plan, const OutputOptions& options);

}  // namespace keyblock
