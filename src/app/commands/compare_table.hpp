// Compared cases and traces as tables for a terminal.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "study/cases/compare.hpp"
#include "study/cases/trace.hpp"

namespace keyblock {

/// Whether the reason of every tolerance is printed too.
enum class Detail { brief, full };

/// One case: a line an expected value with the values of all profiles, a line a variant, the sources by number.
std::string table_of(const study::CaseComparison& comparison, Detail detail);

/// One line a trace; nothing where there is none.
std::string table_of(const std::vector<study::TraceDifference>& traces);

}  // namespace keyblock
