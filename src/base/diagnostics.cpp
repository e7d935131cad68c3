// The rows of the table, by the alphabet of their codes. To add one: put it in its place; `keyblock explain CODE` and
// the tests take it from here.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/diagnostics.hpp"

#include <algorithm>
#include <array>

namespace keyblock {
namespace {

using enum DiagnosticLevel;

constexpr auto kDiagnostics = std::to_array<Diagnostic>({
    {"chain_off_boundary", warning, "A chain of loads leaves the boundary",
     "Part of a chain of tractions or prescribed displacements lies on no edge of a body; that part acts on nothing. "
     "Edges that the chain covers in part are loaded or held on exactly that part.",
     "Move the points of the chain onto the outline, or end the chain where the body ends."},
    {"crushed_beyond_limit", error, "A body was compressed too far",
     "An element lost more of its area than the setting crushing_limit allows; elastic laws do not hold there.",
     "Check the stiffness and the loads; use elastic_law=logarithmic for large compression."},
    {"energy_beyond_limit", error, "Energy came from nothing",
     "The energy balance created more energy than the setting energy_limit allows.",
     "Use a smaller time_step, or damp bodies on covers by stiffness_damping."},
    {"moved_by_start", error, "The initial state moved a block",
     "The start carried a block further than the setting penetration_limit allows: blocks overlap in the input, or "
     "are too soft for their loads.",
     "Correct the overlap in the drawing, or check the stiffness."},
    {"rotated_beyond_linear", error, "Linear statics was used for a large rotation",
     "An element of a body on covers rotates by more than 0.1 rad. Linear statics adds "
     "displacements "
     "as if nothing rotated, and stretches what does by half the square of the angle.",
     "Use the large-strain steps: --set motion=relaxation, with enough steps to come to equilibrium."},
    {"sunk_beyond_limit", error, "Blocks lie too deep in one another",
     "The depth or the common area of two blocks exceeds the setting penetration_limit.",
     "Use a smaller time_step or stiffer contacts."},
});

}  // namespace

std::span<const Diagnostic> diagnostics() {
  return kDiagnostics;
}

const Diagnostic* find_diagnostic(std::string_view code) {
  const auto found = std::ranges::lower_bound(kDiagnostics, code, {}, &Diagnostic::code);
  return found != kDiagnostics.end() && found->code == code ? &*found : nullptr;
}

std::string_view word_of(DiagnosticLevel level) {
  switch (level) {
    case error:
      return "error";
    case warning:
      return "warning";
    case note:
      break;
  }
  return "note";
}

}  // namespace keyblock
