// Describes the results that a caller requests of a run, beside those of its case file.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "formats/views/vtk_file.hpp"
#include "problem/output_plan.hpp"

namespace keyblock {

struct OutputOptions {
  std::vector<std::string> histories;  ///< as `--history` has them
  std::string contacts;                ///< as `--contacts` has it; empty: as the case says
  std::string field;                   ///< quantity of field.svg; empty: the stress that varies most
  std::string frames = formats::vtk_coding_names().front();
  bool has_pictures = true;
};

/// Returns the plan of the case file with these. Throws UsageError for a history or a choice of contacts that it cannot
/// read.
OutputPlan outputs_asked(OutputPlan plan, const OutputOptions& options);

}  // namespace keyblock
