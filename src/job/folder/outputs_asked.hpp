// Describes the results that a caller requests of a run, in addition to those of its case file.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "formats/views/vtk_file.hpp"
#include "problem/output_plan.hpp"

namespace keyblock {

struct OutputOptions {
  std::vector<std::string> histories;  ///< in the form of `--history`
  std::string contacts;                ///< in the form of `--contacts`; empty: as the case requests
  std::string field;                   ///< quantity of field.svg; empty: the stress that varies most
  std::string frames = formats::vtk_coding_names().front();
  bool has_pictures = true;
  bool has_page = false;
};

/// Returns the plan of the case file with the requested results. Throws UsageError if it cannot read a history or a
/// choice of contacts.
OutputPlan outputs_asked(OutputPlan plan, const OutputOptions& options);

}  // namespace keyblock
