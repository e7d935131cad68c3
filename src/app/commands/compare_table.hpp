// Prints compared cases and traces as tables for a terminal.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "study/cases/compare.hpp"
#include "study/cases/trace.hpp"

namespace keyblock {

/// Selects if the reason of every tolerance is printed too.
enum class Detail { brief, full };

/// Returns the table of one case: one line per expected value with the values of all profiles, one line per variant,
/// numbered sources.
std::string table_of(const study::CaseComparison& comparison, Detail detail);

/// Returns one line per trace; empty if there are none.
std::string table_of(const std::vector<study::TraceDifference>& traces);

}  // namespace keyblock
