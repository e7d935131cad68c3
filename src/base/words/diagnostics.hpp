// The table of diagnostics: code, level, summary, meaning and remedy. Codes are moved into it as their texts are
// written; those that it does not hold yet have a level alone (`level_of`).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace keyblock {

enum class DiagnosticLevel {
  error,    ///< the result is not to be trusted, or the input contradicts itself
  warning,  ///< the user should act
  note,     ///< a choice worth knowing: a run counts these, and names their codes
  silent,   ///< bookkeeping: a run puts these into its record alone
};

/// A row of the table. `code` is the name of a `Warning`; the other texts are for readers who know mechanics, not the
/// program.
struct Diagnostic {
  std::string_view code;
  DiagnosticLevel level;
  std::string_view summary;  ///< one line
  std::string_view meaning;  ///< what was found, by which measure and limit
  std::string_view remedy;   ///< what to do
};

/// All rows, by the alphabet of their codes.
std::span<const Diagnostic> diagnostics();

/// The row of `code`; nullptr if the table has none.
const Diagnostic* find_diagnostic(std::string_view code);

/// The level of a code that has no row yet; nothing: none is known of it.
std::optional<DiagnosticLevel> level_without_row(std::string_view code);

/// The level of `code`, also where it has no row yet; a warning where nothing says otherwise.
DiagnosticLevel level_of(std::string_view code);

/// "error", "warning", "note" or "silent".
std::string_view word_of(DiagnosticLevel level);

}  // namespace keyblock
