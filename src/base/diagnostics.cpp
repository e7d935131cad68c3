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
    {"bolt_in_one_block", warning, "Both ends of a bolt lie in one block",
     "A bolt acts between two blocks; with both ends in one it carries nothing. Lines of a bolt symbol (a plate, a "
     "head) on the layer of bolts are read as bolts too.",
     "Draw the bolt across a joint, or move lines that are symbols to another layer."},
    {"bolts_without_properties", warning, "Bolts have no stiffness and no strength",
     "The drawing shows bolts, and neither it nor the analysis says how stiff and strong they are: they carry no "
     "force, and the run is one without bolts.",
     "Give `bolt_properties` in `analysis` of the case file: stiffness, strength and pretension."},
    {"chain_off_boundary", warning, "A chain of loads leaves the boundary",
     "Part of a chain of tractions or prescribed displacements lies on no edge of a body; that part acts on nothing.",
     "Move the points of the chain onto the outline, or end the chain where the body ends."},
    {"crushed_beyond_limit", error, "A body was compressed too far",
     "An element lost more of its area than the setting crushing_limit allows; elastic laws do not hold there.",
     "Check the stiffness and the loads; use elastic_law=logarithmic for large compression."},
    {"dxf_hidden_layers", warning, "Layers that are off or frozen are left out",
     "The drawing hides these layers in the drawing program, so what lies on them is not read.",
     "Switch the layers on in the drawing, or name them in a table of --layers: a row takes its layer, hidden or not."},
    {"dxf_not_clipped", warning, "Joints are not cut off at the outline",
     "The boundary lines do not close: an end is open, or more than two lines meet in a point. Joints that run beyond "
     "the outline make blocks there.",
     "Close the outline at the place named, or close gaps up to a distance by --join DISTANCE."},
    {"dxf_unit_overruled", note, "The unit of the drawing is not the one in the file",
     "--unit counts in place of $INSUNITS of the file.",
     "Nothing, if the unit is right; `check` prints the size of the scene."},
    {"ends_joined", note, "Ends of lines were joined",
     "--join moved ends of lines onto lines nearer than its distance.",
     "Look at the widest gap: if it is too wide, use a smaller distance."},
    {"ends_stop_short", warning, "Ends of lines stop just short of another line",
     "A joint or an outline that ends short of another line by a small gap does not meet it: it bounds no block and is "
     "removed, or ends inside a body.",
     "Use --join DISTANCE with a distance above the gap, or correct the drawing at the place named."},
    {"ends_trimmed", note, "Ends that pass a line were cut off",
     "--join cuts off ends that pass another line by less than its distance.",
     "Nothing, if the ends are overshoots of the drawing; else use a smaller distance."},
    {"energy_beyond_limit", error, "Energy came from nothing",
     "The energy balance created more energy than the setting energy_limit allows.",
     "Use a smaller time_step, or damp bodies on covers by stiffness_damping."},
    {"moved_by_start", error, "The initial state moved a block",
     "The start carried a block further than the setting penetration_limit allows: blocks overlap in the input, or "
     "are too soft for their loads.",
     "Correct the overlap in the drawing, or check the stiffness."},
    {"point_outside_blocks", warning, "Marks lie outside all blocks",
     "A fixed or measured point, an end of a bolt or another mark lies in no block, and not within the merging "
     "distance of one. It is left out; a bolt goes with its end.",
     "Move the mark into a block; check that the unit of the drawing is right."},
    {"points_moved", note, "Marks were moved onto the nearest block",
     "A mark lay outside all blocks, but within the merging distance of one: it was moved onto the outline of that "
     "block.",
     "Nothing, if the mark belongs to that block; else move it."},
    {"sunk_beyond_limit", error, "Blocks lie too deep in one another",
     "The depth or the common area of two blocks exceeds the setting penetration_limit.",
     "Use a smaller time_step or stiffer contacts."},
    {"tables_large", warning, "Tables will be large",
     "The tables of histories and measured points will take more than 100 MB, by the number of steps.",
     "Follow fewer points, or make fewer steps."},
    {"units_contradict", warning, "A value is not plausible in the declared units",
     "A size, density, modulus, gravity or angle is far from what rock, soil and masonry have. Mostly it is in another "
     "unit than the declared one.",
     "Correct the value or `units`; --unit says in which unit a DXF drawing is."},
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
