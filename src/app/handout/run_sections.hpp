// Describes a run for its report: results, stages, model, assumptions, warnings, energies, settings.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/handout/record_reading.hpp"
#include "report/document/document.hpp"

namespace keyblock {

/// Return sections, with empty tables if the record lacks their entries.
report::DocumentSection result_section(const RunRecordFile& record);
report::DocumentSection stage_section(const RunRecordFile& record);
report::DocumentSection model_section(const RunRecordFile& record);
report::DocumentSection assumption_section(const RunRecordFile& record);
report::DocumentSection warning_section(const RunRecordFile& record);
report::DocumentSection energy_section(const RunRecordFile& record);
/// Rules of Shi's programs are one row with those that are on, and none under other profiles.
report::DocumentSection setting_section(const RunRecordFile& record);

}  // namespace keyblock
