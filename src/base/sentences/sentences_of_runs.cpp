// Texts of doubts and warnings about runs.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "base/sentences/sentences.hpp"

namespace keyblock {
namespace {

constexpr auto kSentencesOfRuns = std::to_array<Sentence>({
    {"acceleration_held_after_table",
     "the table of accelerations ends at time {table_end:.6g}, the run at {time:.6g}; the last acceleration stays"},
    {"acceleration_held_before_table",
     "the table of accelerations begins at time {table_start:.6g}; its first acceleration acts from the start"},
    {"block_thrown",
     "energy of one block came from nothing: in step {step} block {element} near ({x}, {y}) moves at {speed:p3}, "
     "while weight, loads and strains of all account for {accounted:p3} at most"},
    {"bolts_broke", "{broken} of {bolts:#bolt} broke: {names}[ and {more} more]; bolts.csv has the frame"},
    {"coarse_tip", "at the tip {x}, {y} the mesh is coarse for the factors of tips.csv: {why}"},
    {"crack_start_on_coarse_mesh",
     "{count:#crack} started in a mesh too coarse for the stress, the first at {x}, {y} in step {step}: sides are "
     "{side:.3g} there, the length (K_Ic/strength)²/π is {length:.3g}, with a strength of {strength:.4g}, that of "
     "the rock; refine to sides of {needed:.3g}"},
    {"crack_start_on_coarse_mesh:at_corner",
     "{count:#crack} started in a mesh too coarse for the stress, the first at {x}, {y} in step {step}: sides are "
     "{side:.3g} there, the length (K_Ic/strength)²/π is {length:.3g}, with a strength of {strength:.4g}, for a "
     "corner that is near and the rock's {of_rock:.4g}; refine to sides of {needed:.3g}"},
    {"crushed_beyond_limit",
     "{noun} {element} was compressed to {share:.4g} of its area[; the St. Venant-Kirchhoff law softens below a "
     "stretch of {softening_stretch:.2g}, elastic_law=logarithmic does not]; limit {limit:.4g} (crushing_limit)"},
    {"crushed_beyond_limit:turned",
     "{noun} {element} is turned inside out: the loads are too large for linear statics"},
    {"deep_penetration",
     "step {step}: blocks overlap by {penetration:.3g}, {times_allowed:.0f} times the allowed penetration"},
    {"energy_beyond_limit",
     "energy came from nothing: {share:.3g} of the largest stored energy; limit {limit:.3g} (energy_limit)[; sliding "
     "NMM bodies may flutter, stiffness_damping={stiffness_damping:.2g} (two steps) damps them]"},
    {"energy_beyond_limit:of_weight",
     "energy came from nothing: {share:.3g} of the work of all weights over {way:g} of a block's size; limit "
     "{limit:.3g} (energy_limit)[; sliding NMM bodies may flutter, stiffness_damping={stiffness_damping:.2g} (two "
     "steps) damps them]"},
    {"energy_lost_in_closing",
     "contacts took {share:.2g} of the largest energy as they closed (closing and clean_up of ledger.csv); in "
     "impacts of NMM bodies this depends on the step, and later motion is too small"},
    {"energy_not_judged", "ledger=off: the run does not check whether energy came from nothing (energy_limit)"},
    {"equilibrium_far_away",
     "the equilibrium lies far from the drawing: {noun} {element} near ({x}, {y}) moved by {displacement:p3}, "
     "{share:.2g} of "
     "its width {width:p3}; limit {limit:g}"},
    {"equilibrium_moved",
     "the equilibrium is not quite that of the drawing: {noun} {element} near ({x}, {y}) moved by {displacement:p3}, "
     "{share:.2g} of its width {width:p3}; gaps closed, parts are soft, or the scene is near its limit"},
    {"equilibrium_moved:rest",
     "the scene came to rest, but not as drawn: {noun} {element} near ({x}, {y}) moved by {displacement:p3}, "
     "{share:.2g} of its width {width:p3}; gaps closed, parts are soft, or the scene is near its limit, where the "
     "outcome depends on how its loads came"},
    {"equilibrium_moved:small",
     "a small loose block found another place: {noun} {element} near ({x}, {y}) moved by {displacement:p3}, "
     "{share:.2g} of its "
     "width {width:p3}"},
    {"faces_overlap_at_tip", "the faces overlap at the tip {x}, {y} at the end: K_I is {share:.2g} of K, below 0"},
    {"faces_overlap_at_tip:extended",
     "the faces overlap at the tip {x}, {y}, which extended in step {step}: K_I is {share:.2g} of K, below 0"},
    {"far_from_equilibrium",
     "static, each step from zero velocity: after {steps} steps the last, {ratio:.3g} of the one before, shows about "
     "{percent:.2g} % of the way to equilibrium"},
    {"far_from_equilibrium:no_sign",
     "static, each step from zero velocity: after {steps} steps the last, {ratio:.3g} of the one before, shows no "
     "sign of an equilibrium"},
    {"history_of_nothing",
     "history \"{history}\": {bore} in any of its rows, so that its forces are 0[; the least gap is {least_gap}][; "
     "before any load they are {apart} apart]"},
    {"increments_too_long",
     "crack {crack}: behind the increment of {increment:.3g} to {x}, {y} (step {step}) K_II is {ratio:.2g} of K_I; "
     "limit {limit:g}"},
    {"large_residual",
     "the equations of {concerned} of {steps} steps are solved to a relative residual of more than {tolerance:.0e}; "
     "the worst is step {step} (time {time:.6g}), to {residual:.1e}"},
    {"large_residual:of_forces",
     "forces are out of balance by more than {tolerance:.0e} of the load in {concerned} of {steps} steps; the worst "
     "is step {step} (time {time:.6g}), by {residual:.1e}[, at the contact of {noun} {element} with {noun} {other} "
     "near {x}, {y} ({contacts} contacts in all, {closed} closed)]"},
    {"load_held_after_table",
     "the table of loads ends at time {table_end:.6g}, the run at {time:.6g}; the last load stays"},
    {"load_held_before_table",
     "the table of loads begins at time {table_start:.6g}; its first load acts from the start"},
    {"moved_by_start",
     "the initial state moves {noun} {element} by {displacement:.3g}, {share:.3g} of its size; limit {limit:.3g} "
     "(penetration_limit)"},
    {"overlaps_locked",
     "step {step}: overlaps left at impacts, because other contacts block them: {overlaps}; as in {concerned} of "
     "{steps} steps"},
    {"overlaps_not_looked_for", "so many corners lie close together that not all were checked for overlaps at the end"},
    {"plastic_work_overstated",
     "steps are long for elastoplastic rock: `algorithmic` of ledger.csv is {algorithmic:.3g}, {percent:.2g} % of "
     "the plastic work {plastic_work:.4g}"},
    {"residual_above_goal",
     "forces are out of balance by more than {tolerance:.0e} of the load in {concerned} of {steps} steps; the worst "
     "is step {step} (time {time:.6g}), by {residual:.1e}[, at the contact of {noun} {element} with {noun} {other} "
     "near {x}, {y} ({contacts} contacts in all, {closed} closed)]"},
    {"rotated_beyond_linear",
     "{noun} {element} rotates by {rotation:.3g} rad; linear statics stretches it by {stretch_percent:.2g} %, and "
     "results hold for small displacements only"},
    {"stage_not_balanced", "stage {stage}[ ({name})] ends after step {step} without the required equilibrium"},
    {"start_settled:gaps_left", "the initial state leaves {misfit:.1e} of the gaps that it should close"},
    {"start_settled:no_forces", "{steps:#step} of the initial state found no contact forces"},
    {"start_settled:one_of_several",
     "the initial contact forces are one of several possible sets, {made}, because {why}"},
    {"start_without_rest", "{why}"},
    {"step_above_limit",
     "step {step}: the automatic step, {dt:.6g}, exceeds the limit of the file, {limit:.6g}, as in the Berkeley "
     "program"},
    {"step_cut",
     "step {step}: cut from {time_step:.6g} to {dt:.6g}, because blocks moved too far or contacts did not settle"},
    {"step_cut:stays",
     "step {step}: cut from {time_step:.6g} to {dt:.6g}, because blocks moved too far or contacts did not settle; "
     "the cut stays"},
    {"step_in_parts",
     "step {step} was made in {parts} parts, near a limit load or too long for elastoplastic rock; as in {concerned} "
     "of {steps} steps"},
    {"step_moves_far",
     "step {step}: a block moves {ratio:.3g} times the displacement allowed in a step, as in {concerned} of {steps} "
     "steps"},
    {"step_passes_blocks",
     "step {step}: a block moves {displacement:p3}, further than blocks are wide ({width:p3}), as in {concerned} of "
     "{steps} steps; it may have passed through others"},
    {"step_unresolved",
     "step {step}: {parts} of its parts have the least size (least_step_share) and still exceed the permitted "
     "displacement or error, as in {concerned} of {steps} steps"},
    {"strained_beyond_linear",
     "{noun} {element} carries a stress of {strain:.2g} of its modulus; in linear statics, results hold for small "
     "strains only"},
    {"sunk_beyond_limit",
     "blocks overlapped by {share:.3g} of the size of the smaller; limit {limit:.3g} (penetration_limit)"},
    {"sunk_beyond_limit:at_end",
     "{noun} {element} and {noun} {other} share {share:.3g} of the smaller one's area at the end; limit {limit:.3g} "
     "(penetration_limit)"},
    {"tension_without_strength",
     "block {element} near ({x}, {y}) hangs on block {other}: contacts without tensile strength carry {share:.2g} of "
     "its weight as tension in {concerned} of {frames} frames, which Shi's rules permit"},
    {"tip_without_factors",
     "tip {tip} at {x}, {y} has no K and no J: every domain about it contains other lines, loads or edges"},
    {"tip_without_room",
     "tip {tip} at {x}, {y} has no stress intensity factors, because every domain about it contains other lines; "
     "whether it extends is unknown"},
    {"tips_still_go_on", "tip {tip} at {x}, {y} still extends under the loads of the last step"},
    {"turned_in_a_step",
     "contacts turned block {element} near ({x}, {y}) by {degrees:.3g} degrees in step {step}; beyond "
     "{limit_degrees:.2g} the step does not resolve the impact or overlap"},
    {"unbalanced_steps",
     "forces are out of balance by more than {tolerance:.0e} of the load in {concerned} of {steps} steps, the worst "
     "by {residual:.1e}; limit {limit_percent:g} % of the steps"},
    {"unsettled_step_accepted",
     "step {step}: {contacts:#contact} still opened or closed after the last open-close iteration"},
});

}  // namespace

std::span<const Sentence> sentences_of_runs() {
  return kSentencesOfRuns;
}

}  // namespace keyblock
