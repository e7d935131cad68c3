// Lists the materials of a result for its report.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/handout/record_reading.hpp"
#include "report/document/document.hpp"

namespace keyblock {

/// Returns tables of rocks and joints, read from the input files of the record, with the values that were changed after
/// reading. Says so in a sentence if a file is no longer there, or has changed since.
report::DocumentSection material_section(const ResultRecord& record);

}  // namespace keyblock
