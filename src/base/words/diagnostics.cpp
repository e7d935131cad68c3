// The rows of the table, by the alphabet of their codes. To add one: put it in its place; `keyblock explain CODE` and
// the tests take it from here.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/words/diagnostics.hpp"

#include <algorithm>
#include <array>

namespace keyblock {
namespace {

using enum DiagnosticLevel;

// Levels of codes that have no row yet; all others are warnings.
constexpr auto kNotesWithoutRow = std::to_array<std::string_view>({"block_inside_block",
                                                                   "bolts_not_read",
                                                                   "bolts_with_block_numbers",
                                                                   "boundaries_dropped",
                                                                   "bridge_lines_removed",
                                                                   "comments_dropped",
                                                                   "contact_damping_without_effect",
                                                                   "contact_stiffness_zero",
                                                                   "contacts_thinned",
                                                                   "damping_without_effect",
                                                                   "dangling_lines_removed",
                                                                   "default_analysistype",
                                                                   "default_autopenalty",
                                                                   "default_autotimestep",
                                                                   "default_damping",
                                                                   "default_gravaccel",
                                                                   "default_gravity",
                                                                   "default_pfactor",
                                                                   "default_planestrain",
                                                                   "default_rotation",
                                                                   "defaults_taken",
                                                                   "duplicate_line",
                                                                   "dxf_clipped",
                                                                   "dxf_old_marks",
                                                                   "dxf_scaled_to_declared_unit",
                                                                   "dxf_scaled_to_metres",
                                                                   "dxf_vertex_count",
                                                                   "edge_node_ratio_unusual",
                                                                   "edges_rerouted",
                                                                   "energy_not_judged",
                                                                   "first_material_line_lost",
                                                                   "fixed_points_of_two_numbers",
                                                                   "gradient_from_velocity",
                                                                   "history_of_distant_blocks",
                                                                   "hole_count_missing",
                                                                   "initial_strain_without_effect",
                                                                   "leaving_edge_materials",
                                                                   "merging_left_close_nodes",
                                                                   "mesh_error_at_points",
                                                                   "motion_applied",
                                                                   "near_pieces_deleted",
                                                                   "not_of_berkeley",
                                                                   "overlapping_lines",
                                                                   "overlaps_locked",
                                                                   "overlaps_not_looked_for",
                                                                   "plane_not_read",
                                                                   "repeated_element",
                                                                   "several_cases",
                                                                   "sliver_removed",
                                                                   "slivers_glued",
                                                                   "slivers_left_out",
                                                                   "soft_patterns",
                                                                   "springs_stiff_for_step",
                                                                   "start_settled",
                                                                   "step_above_limit",
                                                                   "step_cut",
                                                                   "step_in_parts",
                                                                   "step_moves_far",
                                                                   "strain_without_effect",
                                                                   "unsupported_blocks",
                                                                   "velocity_from_gradient",
                                                                   "zero_length_line"});
constexpr auto kSilentWithoutRow =
    std::to_array<std::string_view>({"default_edge_node_ratio", "dxf_curves_as_chords", "final_numbers_ignored",
                                     "nodes_merged", "nodes_placed_otherwise", "over_relaxation_without_effect"});

constexpr auto kDiagnostics = std::to_array<Diagnostic>({
    {"block_thrown", error, "Energy of one block came from nothing",
     "A block moves faster than ten times what the fall of blocks, their first speeds, released strain and the work of "
     "loads on it account for. The energy balance of the whole scene does not show it where the block is small.",
     "Use a smaller time_step; under profile legacy draw no block much smaller than the others, or use profile "
     "standard."},
    {"bolt_in_one_block", warning, "Both ends of a bolt lie in one block",
     "A bolt acts between two blocks; with both ends in one it carries nothing. Lines of a bolt symbol (a plate, a "
     "head) on the layer of bolts are read as bolts too.",
     "Draw the bolt across a joint, or move lines that are symbols to another layer."},
    {"bolts_without_properties", warning, "Bolts have no stiffness and no strength",
     "The drawing shows bolts, and neither it nor the analysis says how stiff and strong they are: they carry no "
     "force, and the run is one without bolts.",
     "Give `bolt_properties` in `analysis` of the case file: stiffness, strength and pretension."},
    {"bonded_crack_faces", warning, "The faces of a crack are bonded",
     "The joint material of a crack, or of a joint that ends in rock, has cohesion or tensile strength, and contact is "
     "felt: its faces hold each other, and K is that of a bonded crack until the bonds break.",
     "Give the crack a joint material without cohesion and tensile strength (joint_material of the crack)."},
    {"chain_off_boundary", warning, "A chain of loads leaves the boundary",
     "Part of a chain of tractions or prescribed displacements lies on no edge of a body; that part acts on nothing. "
     "Edges that the chain covers in part are loaded or held on exactly that part.",
     "Move the points of the chain onto the outline, or end the chain where the body ends."},
    {"crack_start_on_coarse_mesh", error, "A crack started where the mesh is coarse",
     "Sides of the mesh are longer than half of (K_Ic/strength)²/π, the length over which stress is averaged before it "
     "is compared with the strength.",
     "Refine the mesh there (mesh.refined)."},
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
    {"equilibrium_far_away", error, "The equilibrium lies far from the drawing",
     "The equilibrium that statics found lies more than a tenth of the width of a block away from the drawing. Loads "
     "are "
     "not in equilibrium where the blocks were drawn; they came to rest after a slide, a fall or a rotation. Width is "
     "area over twice the distance of the farthest vertex from the centroid; prescribed displacements do not count.",
     "Find the factor of safety by keyblock fos, or look at the motion by motion=dynamic."},
    {"equilibrium_moved", warning, "The equilibrium is not quite that of the drawing",
     "The equilibrium that statics found lies more than 0.005 of the width of a block away from the drawing, more than "
     "elastic settlement of rock. Scenes near their limit move so; so do gaps that close.",
     "Find out by keyblock fos how near the limit is."},
    {"faces_overlap_at_tip", error, "The faces of a crack lie in one another at its tip",
     "K_I is below 0 by more than 3 % of K: the crack is pressed, and contact is ignored or does not act there.",
     "Set contact to felt in the section covers: the faces then touch, K_I is 0 and friction has its part in K_II."},
    {"free_blocks", note, "Blocks move freely at the start",
     "These blocks touch nothing and hang on no bolt. In a run of motion they fall or fly, which is what such cases "
     "are "
     "drawn for.",
     "Nothing, if they are meant to. Otherwise close the gaps of the drawing."},
    {"increments_too_long", warning, "The increments of a crack are too long for its path",
     "Behind an increment K_II is more than 8 % of K_I; on the true path it is 0.",
     "Halve growth.increment until the path stays where it is."},
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
    {"rotated_beyond_linear", warning, "Linear statics was used for a large rotation",
     "An element of an NMM body rotates by more than 0.1 rad. Linear statics adds displacements as if nothing rotated, "
     "and stretches what does by half the square of the angle: 0.5 % at 0.1 rad.",
     "Let the body come to rest in time: --set motion=dynamic --set start=sudden, with mass_damping and a short "
     "time_step."},
    {"springs_unresolved", warning, "The step is too long for the contact springs",
     "With impact=springs the lightest free body swings on the springs of two corners with the frequency omega = "
     "sqrt(2 contact_penalty / mass). If omega dt exceeds 1, a blow lasts fewer than four steps, and its rebound and "
     "forces depend on the step.",
     "Use a time_step of pi/(20 omega), or a smaller contact_penalty."},
    {"strain_damping_takes_rebound", warning, "Damping of strain takes the rebound",
     "With impact=springs a block that strikes strains as it rebounds. Damping of that strain takes energy which the "
     "springs would give back. The estimate is that of a square of the lightest block's mass on a rigid floor.",
     "Use strain_damping=none (or stiffness_damping=0) for rebounds, or impact=jump with restitution."},
    {"strained_beyond_linear", warning, "Linear statics was used for a large strain",
     "An element of an NMM body bears a stress above a tenth of its modulus. Linear statics knows small strains alone.",
     "Check the units of loads and modulus. For large strains come to rest in time: --set motion=dynamic --set "
     "start=sudden, with mass_damping."},
    {"sunk_beyond_limit", error, "Blocks lie too deep in one another",
     "The depth or the common area of two blocks exceeds the setting penetration_limit.",
     "Use a smaller time_step or stiffer contacts."},
    {"tables_large", warning, "Tables will be large",
     "The tables of histories and measured points will take more than 100 MB, by the number of steps.",
     "Follow fewer points, or make fewer steps."},
    {"tension_without_strength", error, "Contacts without tensile strength carry tension",
     "In more than half of the frames a block hangs on contacts whose joint material has no tensile strength. The "
     "rules "
     "of Shi's programs let a contact pull until its faces have parted by a share of the size of the scene.",
     "Use profile standard."},
    {"turned_in_a_step", error, "Contacts turned a block by a large angle within a step",
     "In one step a block turned by more than 0.5 rad beside what its spin accounts for. The step does not resolve "
     "what "
     "it met: it may have been struck, or pushed out of an overlap, the wrong way.",
     "Use a smaller time_step."},
    {"unbalanced_steps", error, "Forces are out of balance in many steps",
     "Contact forces were left out of balance by more than 1e-4 of the largest load in more than a tenth of the steps.",
     "Use a smaller time_step or softer contacts, and remove slivers (slivers=glue)."},
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

std::optional<DiagnosticLevel> level_without_row(std::string_view code) {
  const auto holds = [code](const auto& codes) { return std::ranges::find(codes, code) != codes.end(); };
  if (holds(kNotesWithoutRow)) return note;
  if (holds(kSilentWithoutRow)) return silent;
  return std::nullopt;
}

DiagnosticLevel level_of(std::string_view code) {
  if (const Diagnostic* row = find_diagnostic(code)) return row->level;
  return level_without_row(code).value_or(warning);
}

std::string_view word_of(DiagnosticLevel level) {
  switch (level) {
    case error:
      return "error";
    case warning:
      return "warning";
    case note:
      return "note";
    case silent:
      break;
  }
  return "silent";
}

}  // namespace keyblock
