// Declares the table of diagnostics: code, level, summary, meaning and remedy of every warning and doubt.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

#include "base/words/diagnostic.hpp"

namespace keyblock {

/// All rows, sorted by code.
std::span<const Diagnostic> diagnostics();

/// The row of `code`; nullptr if the table has none.
const Diagnostic* find_diagnostic(std::string_view code);

/// The level of `code`; a warning if the table has no such row.
DiagnosticLevel level_of(std::string_view code);

/// "error", "warning", "note" or "silent".
std::string_view word_of(DiagnosticLevel level);

}  // namespace keyblock
