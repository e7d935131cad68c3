// Sums up the tables of a run for its report: bolts, contacts, cracks, and the checksums of all files.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "app/handout/record_reading.hpp"
#include "report/document/document.hpp"

namespace keyblock {

/// Returns the forces of the bolts, at the end and at most; tension is positive. Empty without bolts.csv.
report::DocumentSection bolt_section(const std::filesystem::path& folder, const RunRecordFile& record);

/// Returns the contacts of each joint material in the last recorded frame. Empty without contacts.csv.
report::DocumentSection contact_section(const std::filesystem::path& folder, const RunRecordFile& record);

/// Returns the crack tips of the last recorded step: places, lengths and stress intensity factors. Empty without
/// tips.csv.
report::DocumentSection crack_section(const std::filesystem::path& folder, const RunRecordFile& record);

/// Returns SHA-256 of the input files as they were read, and of its tables and pictures as they are now.
report::DocumentSection checksum_section(const std::filesystem::path& folder, const ResultRecord& record);

}  // namespace keyblock
