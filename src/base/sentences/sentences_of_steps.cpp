// Texts of failures of steps.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "base/sentences/sentences.hpp"

namespace keyblock {
namespace {

constexpr auto kSentencesOfSteps = std::to_array<Sentence>({
    {"alone", "{why}"},
    {"blocks_move_too_far",
     "blocks move too far even at the smallest step: block {element} at {x}, {y} (area {area:p3}; drawn with "
     "{drawn_area:p3}, {percent_of_mean:.2g} % of the mean) by {displacement:p3}; a step may move {limit:p3} "
     "({limit_ratio:g} times allowed_displacement_ratio times half the size of the scene)[; the step before moved "
     "{last_ratio:.3g} times allowed_displacement_ratio, and velocities from the next step size let free blocks "
     "move twice as far in it, however short it is]; Shi's programs repeat such a step without end"},
    {"blocks_move_too_far:in_attempts",
     "blocks move too far in {attempts} redone attempts: block {element} at {x}, {y} (area {area:p3}; drawn with "
     "{drawn_area:p3}, {percent_of_mean:.2g} % of the mean) by {displacement:p3}; a step may move {limit:p3} "
     "({limit_ratio:g} times allowed_displacement_ratio times half the size of the scene)[; the step before moved "
     "{last_ratio:.3g} times allowed_displacement_ratio, and velocities from the next step size let free blocks "
     "move twice as far in it, however short it is]; Shi's programs repeat such a step without end"},
    {"blocks_move_without_bound", "blocks move without bound"},
    {"blocks_overlap_deeply",
     "{one} and {two} overlap by {depth:.3g}, {share:.2g} of the size of the smaller; beyond {limit:.2g} "
     "(penetration_limit) later results are unreliable"},
    {"contacts_do_not_settle",
     "contact forces do not settle, residual {residual:.3g} of the largest load[; undecided contacts: {undecided}]"},
    {"contacts_stay_deep", "contacts stay too deep in {attempts} redone attempts"},
    {"contacts_without_end",
     "{unsettled} of {contacts} contacts open and close without end: {names}; Shi's programs repeat such a step "
     "without end"},
    {"crack_faces_do_not_settle", "the forces between the faces of cracks do not settle"},
    {"cracks_cannot_go_on", "cracks cannot go on so: {input}"},
    {"cracks_part_body",
     "cracks part a body, and there is no equilibrium under the given loads: the piece about ({x:.6g}, {y:.6g}), "
     "cut off along the way from ({start_x:.6g}, {start_y:.6g}) to ({end_x:.6g}, {end_y:.6g}), moves away"},
    {"in_load_step", "load step {step}: {why}"},
    {"in_step", "step {step} (time {time:r}): {why}"},
    {"in_step:shi", "step {step} (time {time:r}, dt {dt:r}): {why}"},
    {"in_step_alone", "step {step}: {why}"},
    {"limit_load",
     "limit load of this mesh: no equilibrium beyond {load_share:.4g} of the loads of this scene was found "
     "({iterations} Newton iterations, {cuts} cuts of the step, the last by {cut_by}); with displacements "
     "{more_percent:g} % larger it carries {share_further_on:.4g}"},
    {"loads_not_finite", "the loads are too great to be calculated with"},
    {"no_contact_forces_found", "no equilibrium: the search for contact forces does not converge"},
    {"no_equilibrium",
     "no equilibrium: {noun} {element} accelerates (at {x}, {y}; area {area:p3}, {percent_of_mean:.3g} % of the "
     "mean)[; its body has fewer than two fixed points{least_fixed_points:?}]"},
    {"no_equilibrium:several",
     "no equilibrium: {noun}s {elements} accelerate (the smallest, {smallest}, at {x}, {y}; area {area:p3}, "
     "{percent_of_mean:.3g} % of the mean)[; its body has fewer than two fixed points{least_fixed_points:?}]"},
    {"no_equilibrium_along_path",
     "no equilibrium was found further along the path, at {load_share:r} of the loads of this scene ({iterations} "
     "Newton iterations, {cuts} cuts of the step, the last by {cut_by})"},
    {"no_equilibrium_beyond",
     "stopped: no equilibrium beyond {load_share:.4g} of the loads of this scene was found ({iterations} Newton "
     "iterations, {cuts} cuts of the step, the last by {cut_by}): whether the rock carries more is not known"},
    {"no_equilibrium_beyond:driven",
     "stopped: no equilibrium beyond {load_share:.4g} of the displacements and loads of this scene was found "
     "({iterations} Newton iterations, {cuts} cuts of the step, the last by {cut_by}): edges are driven, so that "
     "this need not be a limit load: more steps may go on, unless an element is turned over"},
    {"no_equilibrium_beyond:elastic",
     "stopped: no equilibrium beyond {load_share:.4g} of the loads of this scene was found ({iterations} Newton "
     "iterations, {cuts} cuts of the step, the last by {cut_by}): this is no limit load, for no rock has yielded"},
    {"no_equilibrium_found",
     "no equilibrium found in {iterations} iterations, forces out of balance by {residual:.1e} of the load"},
    {"no_load_factor", "no factor of the loads brings a tip to its toughness within {percent:r} %"},
    {"no_motion_balances",
     "no motion balances the step, in which nothing touches: {end}; try a shorter time_step[; undecided contacts: "
     "{undecided}]"},
    {"no_resistance", "bodies give way to the loads without resistance"},
    {"no_start", "no start under the first loads: {block} is turned inside out or no longer finite"},
    {"no_tip_extends", "no tip extends and no crack starts: nothing pulls at any, or the rock there has no toughness"},
    {"no_tip_extends:pressed",
     "no tip extends and no crack starts: the faces of cracks are pressed together (K_I below 0), and slide by no "
     "more than the error of K"},
    {"not_positive_definite", "{system}"},
    {"piece_without_support", "{piece}[ (and {more} more)]"},
    {"solution_out_of_balance", "the solution leaves forces out of balance by {residual:.1e} of the load"},
    {"system_not_solved", "the system of equations could not be solved"},
    {"tip_cannot_go_on",
     "{name} cannot go on: {nearest} is {room:.4g} away, and no domain of elements of the size there fits "
     "before it: a smaller tip_side, or another increment"},
    {"turned_inside_out",
     "{block} is turned inside out or no longer finite[: its body may snap through or buckle under this load (more "
     "steps show at which load it does){may_buckle}][; one step earlier it was compressed to {share_before:.2g} of "
     "its area]"},
    {"turned_inside_out:shi",
     "block {element} is turned inside out or no longer finite; before the step it was block {element} at {x}, {y} "
     "(area {area:p3}; drawn with {drawn_area:p3}, {percent_of_mean:.2g} % of the mean); Shi's programs have no "
     "such test, and continue"},
    {"turned_inside_out:softened",
     "{block} is turned inside out or no longer finite[: its body may snap through or buckle under this load (more "
     "steps show at which load it does){may_buckle}][; a step before it had been compressed to {share_before:.2g} "
     "of its area, and the St. Venant-Kirchhoff law softens below a stretch of {softening_stretch:.2g} "
     "(elastic_law = logarithmic does not)]"},
});

}  // namespace

std::span<const Sentence> sentences_of_steps() {
  return kSentencesOfSteps;
}

}  // namespace keyblock
