// Declares a row of the table of diagnostics: code, level, summary, meaning and remedy.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace keyblock {

enum class DiagnosticLevel {
  error,    ///< the result is unreliable, or the input contradicts itself
  warning,  ///< the user should act
  note,     ///< a choice worth knowing: a run prints their number and codes
  silent,   ///< bookkeeping: a run puts these into its record only
};

/// A row of the table. `code` is the name of a `Warning`; the texts are for readers who know mechanics.
struct Diagnostic {
  std::string_view code;
  DiagnosticLevel level;
  std::string_view summary;  ///< what happened: at most 80 characters, no full stop
  std::string_view meaning;  ///< what was found, by which measure and limit: at most three sentences
  std::string_view remedy;   ///< what to do: the line `help` of messages
};

}  // namespace keyblock
