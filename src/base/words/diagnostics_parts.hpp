// Declares the parts of the table of diagnostics, by origin of codes. Each is sorted; diagnostics.cpp joins them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include "base/words/diagnostic.hpp"

namespace keyblock::diagnostic_rows {

std::span<const Diagnostic> of_readers();
std::span<const Diagnostic> of_cuts();
std::span<const Diagnostic> of_cases();
std::span<const Diagnostic> of_runs();
std::span<const Diagnostic> of_commands();

/// All parts.
inline std::array<std::span<const Diagnostic>, 5> parts() {
  return {of_readers(), of_cuts(), of_cases(), of_runs(), of_commands()};
}

}  // namespace keyblock::diagnostic_rows
