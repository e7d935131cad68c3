// Joins the parts of the table and looks codes up. To add a code: put a row into its part, in the order of codes
// (diagnostics_of_*.cpp); `keyblock explain CODE`, messages and the tests take it from there.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/words/diagnostics.hpp"

#include <algorithm>
#include <vector>

#include "base/words/diagnostics_parts.hpp"

namespace keyblock {

std::span<const Diagnostic> diagnostics() {
  static const std::vector<Diagnostic> kAll = [] {
    std::vector<Diagnostic> all;
    for (const std::span<const Diagnostic> part : diagnostic_rows::parts())
      all.insert(all.end(), part.begin(), part.end());
    std::ranges::sort(all, {}, &Diagnostic::code);
    return all;
  }();
  return kAll;
}

const Diagnostic* find_diagnostic(std::string_view code) {
  const std::span<const Diagnostic> all = diagnostics();
  const auto found = std::ranges::lower_bound(all, code, {}, &Diagnostic::code);
  return found != all.end() && found->code == code ? &*found : nullptr;
}

DiagnosticLevel level_of(std::string_view code) {
  const Diagnostic* row = find_diagnostic(code);
  return row == nullptr ? DiagnosticLevel::warning : row->level;
}

std::string_view word_of(DiagnosticLevel level) {
  switch (level) {
    case DiagnosticLevel::error:
      return "error";
    case DiagnosticLevel::warning:
      return "warning";
    case DiagnosticLevel::note:
      return "note";
    case DiagnosticLevel::silent:
      break;
  }
  return "silent";
}

}  // namespace keyblock
