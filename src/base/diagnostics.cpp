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
     "Part of a chain of tractions or prescribed displacements lies on no edge of a body; that part acts on nothing.",
     "Move the points of the chain onto the outline, or end the chain where the body ends."},
    {"bonded_crack_faces", warning, "The faces of a crack are bonded",
     "The joint material of a crack, or of a joint that ends in rock, has cohesion or tensile strength, and contact is "
     "felt: its faces hold each other, and K is that of a bonded crack.",
     "Give the crack a joint material without cohesion and tensile strength (joint_material of the crack)."},
    {"crack_start_on_coarse_mesh", error, "A crack started where the mesh is coarse",
     "Sides of the mesh are longer than half of (K_Ic/strength)²/π, the length over which stress is averaged before it "
     "is compared with the strength.",
     "Refine the mesh there (mesh.refined)."},
    {"crushed_beyond_limit", error, "A body was compressed too far",
     "An element lost more of its area than the setting crushing_limit allows; elastic laws do not hold there.",
     "Check the stiffness and the loads; use elastic_law=logarithmic for large compression."},
    {"energy_beyond_limit", error, "Energy came from nothing",
     "The energy balance created more energy than the setting energy_limit allows.",
     "Use a smaller time_step, or damp bodies on covers by stiffness_damping."},
    {"faces_overlap_at_tip", error, "The faces of a crack lie in one another at its tip",
     "K_I is below 0 by more than 3 % of K: the crack is pressed, and contact is ignored or does not act there.",
     "Set contact to felt in the section covers: the faces then touch, K_I is 0 and friction has its part in K_II."},
    {"increments_too_long", warning, "The increments of a crack are too long for its path",
     "Behind an increment K_II is more than 8 % of K_I; on the true path it is 0.",
     "Halve growth.increment until the path stays where it is."},
    {"moved_by_start", error, "The initial state moved a block",
     "The start carried a block further than the setting penetration_limit allows: blocks overlap in the input, or "
     "are too soft for their loads.",
     "Correct the overlap in the drawing, or check the stiffness."},
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
