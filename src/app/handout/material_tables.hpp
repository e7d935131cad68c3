// Lists the materials of a run for its report.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/handout/record_reading.hpp"
#include "report/document/document.hpp"

namespace keyblock {

/// Returns tables of rocks and joints, read from the input files of the run. Says so in a sentence if a file is no
/// longer there, or has changed since the run.
report::DocumentSection material_section(const RunRecordFile& record);

}  // namespace keyblock
