// Describes a run before its first step in one line.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "job/run_report.hpp"
#include "run/prepare.hpp"

namespace keyblock {

/// Returns "slope.json: 65 blocks (23 fixed), 30 m by 14 m, dynamic, 300 steps of 1 ms, profile standard".
std::string first_line(const std::string& file, const Prepared& prepared, const RunRecord& record);

}  // namespace keyblock
