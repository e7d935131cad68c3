// Rows of warnings and doubts about the steps of a run, its energy, its equilibrium and its cracks.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "base/words/diagnostics_parts.hpp"

namespace keyblock::diagnostic_rows {
namespace {

using enum DiagnosticLevel;

constexpr auto kRuns = std::to_array<Diagnostic>({
    {"acceleration_held_after_table", warning, "The run is longer than its table of accelerations",
     "The table of body accelerations ends before the run, with a value that is not 0. That value is held until the "
     "end.",
     "Extend the table by a row of 0, or make fewer steps."},
    {"acceleration_held_before_table", warning, "The table of accelerations begins after the run",
     "The first row of the table of body accelerations has a time after 0, and a value that is not 0. That value acts "
     "from the start of the run.",
     "Begin the table with a row of 0 at that time, or with its first value at time 0."},
    {"block_thrown", error, "Energy of one block came from nothing",
     "A block is faster than ten times what falling blocks, first speeds, released strain and loads account for. "
     "The energy balance of the scene does not show this if the block is small.",
     "Use a smaller time_step; under profile legacy avoid very small blocks, or use profile standard."},
    {"bolts_broke", warning, "Bolts broke",
     "The force in a bolt reached its strength. From then on it carries nothing; bolts.csv shows the frame.",
     "Nothing, if this is the answer; else use stronger or more bolts."},
    {"coarse_tip", warning, "The mesh is coarse at a crack tip",
     "Sides at the tip exceed a fortieth of the free distance about it, or a third of it with near-tip functions. "
     "Stress intensity factors of tips.csv may be off by 3 % or more without such functions.",
     "Set tip_side of the mesh to a fortieth of the distance named, or use tip_functions."},
    {"contacts_thinned", note, "Tables of contacts hold some frames only",
     "contacts.csv, joints.csv and joint_lines.csv would exceed 500,000 rows. They hold one frame of several.",
     "Nothing, if these frames will do; --contacts all writes every frame."},
    {"crack_start_on_coarse_mesh", error, "A crack started where the mesh is coarse",
     "Sides of the mesh are longer than half of (K_Ic/strength)²/π. Over this length stress is averaged before it "
     "is compared with the strength.",
     "Refine the mesh there (`refined` of the mesh)."},
    {"crushed_beyond_limit", error, "A body was compressed too far",
     "A block or element was pressed to less than crushing_limit (0.58) of its area. In linear statics the limit is "
     "0: the element is turned inside out.",
     "Check the stiffness, the loads and their units; for large compression use elastic_law=logarithmic."},
    {"deep_penetration", warning, "Blocks lie deep in one another",
     "The penetration of a contact exceeds ten times the allowed one, which is allowed_penetration times half the "
     "size of the scene.",
     "Use a smaller time_step or stiffer contacts (contact_penalty)."},
    {"energy_beyond_limit", error, "Energy came from nothing",
     "The energy balance created more than energy_limit (0.01) of the largest stored energy. If the work of all "
     "weights over 1e-4 of a block's size is more, it is the measure.",
     "Use a smaller time_step; damp sliding NMM bodies by stiffness_damping."},
    {"energy_lost_in_closing", warning, "Closing contacts of NMM bodies took much energy",
     "Contacts took more than a tenth of the largest energy as they closed (closing and clean_up of ledger.csv). In "
     "impacts of NMM bodies this depends on the step, and later motion is too small.",
     "Compare with a smaller time_step, or with impact=springs."},
    {"energy_not_judged", note, "Energy was not checked",
     "Under ledger=off the run keeps no energy balance. Energy from nothing would not be found.",
     "Nothing, if energy does not matter; else --set ledger=on."},
    {"equilibrium_far_away", error, "The equilibrium lies far from the drawing",
     "A block is displaced by more than a tenth of its width, beyond prescribed displacements. Width is area over "
     "twice the distance of the farthest vertex from the centroid. The scene as drawn may be unstable.",
     "Find the factor of safety by `keyblock fos`, or the motion by --set motion=dynamic."},
    {"equilibrium_moved", warning, "The equilibrium is not quite that of the drawing",
     "A block is displaced by more than 0.005 of its width, or a small loose block by more than a tenth. Elastic "
     "settlement of rock is smaller; scenes near their limit and closing gaps move more. Friction then permits several "
     "equilibria, and the outcome depends on how the loads came.",
     "Find by `keyblock fos` how near the limit is."},
    {"faces_overlap_at_tip", error, "The faces of a crack overlap at its tip",
     "K_I is below 0 by more than 3 % of K: the crack is pressed, and contact is ignored or does not act there.",
     "Set `contact` of the section `covers` to felt: faces then touch, and friction acts on them."},
    {"far_from_equilibrium", warning, "The steps have not reached equilibrium",
     "Each static step starts at rest. From the ratio of the last two steps, the run is at most 99 % of the way to "
     "equilibrium, or shows none.",
     "Make more steps (--set steps=N), or use --profile standard --set motion=static."},
    {"history_of_nothing", warning, "A history holds zeros only",
     "The contact, joint or line of a history carried no force in any of its rows. Its forces are 0.",
     "Check the numbers or the place of the history in the picture."},
    {"increments_too_long", warning, "The increments of a crack are too long for its path",
     "Behind an increment, K_II is more than 8 % of K_I. On the true path it is 0.",
     "Halve `increment` of `growth` until the path no longer changes."},
    {"large_residual", warning, "Forces are out of balance",
     "Under profile standard, contact forces leave more than 1e-4 of the load out of balance in a step. Under "
     "legacy, the relative residual of the equations exceeds 1e-9.",
     "Use a smaller time_step or softer contacts, and remove slivers (slivers=glue)."},
    {"load_held_after_table", warning, "The run is longer than its table of loads",
     "The table of a point load ends before the run, with a load that is not 0. That load is held until the end.",
     "Extend the table, or make fewer steps."},
    {"load_held_before_table", warning, "The table of loads begins after the run",
     "The first row of the table of a point load has a time after 0, and a load that is not 0. That load acts from the "
     "start of the run.",
     "Begin the table with a row of 0 at that time, or with its first load at time 0."},
    {"moved_by_start", error, "The initial state moved a block",
     "The start displaced a block by more than penetration_limit (0.1) of its size. Blocks overlap in the input, or "
     "are too soft for their loads.",
     "Correct the overlap in the drawing, or check the stiffness and the units."},
    {"overlaps_locked", note, "Overlaps remain after impacts",
     "An impact left an overlap, because other contacts of the blocks are in its path.",
     "Nothing, if the overlaps stay small; else use a smaller time_step."},
    {"plastic_work_overstated", warning, "Steps are long for elastoplastic rock",
     "The energy balance counts plastic work by the stress at the end of a step, forces by the mean of start and "
     "end. The difference exceeds a tenth of the plastic work.",
     "Use a smaller time_step."},
    {"residual_above_goal", note, "Forces are not in balance to full accuracy",
     "Under profile standard, contact forces leave more than 1e-6 of the load out of balance in a step, but at most "
     "1e-4.",
     "Nothing, if few steps are concerned; else use a smaller time_step or softer contacts."},
    {"rotated_beyond_linear", warning, "Linear statics was used for a large rotation",
     "An element of an NMM body rotates by more than 0.1 rad. Linear statics stretches it by half the square of the "
     "angle, 0.5 % at 0.1 rad.",
     "--set motion=dynamic --set start=sudden, with mass_damping and a short time_step, allows large rotations."},
    {"stage_not_balanced", error, "A stage ended before its equilibrium",
     "The stage gives a limit `equilibrium` of unbalanced forces. Its steps or its duration ended before forces and "
     "speeds fell below it.",
     "Give the stage more steps, or damping (mass_damping)."},
    {"start_settled", note, "The initial contact forces are one of several sets",
     "In a jointed mass friction can share loads in many ways. The start held the joints together under the loads, or "
     "took the forces of the initial stress, then released them. It may also have left more than 1e-6 of the gaps, or "
     "found no forces in some steps.",
     "Nothing, if any such set will do; --set start=sudden starts without equilibrium."},
    {"start_without_rest", warning, "Some bodies start without equilibrium",
     "No equilibrium was found near the drawing for these bodies. They begin with the strains of their first "
     "acceleration if they touch a support; else they are suddenly loaded.",
     "Support these bodies, or damp them (mass_damping) until they come to rest."},
    {"step_above_limit", note, "Automatic steps exceed the time step of the file",
     "Under an automatic step control the step exceeded time_step, as in the Berkeley program.",
     "Nothing, if Berkeley results are wanted; else --set step_control=constant."},
    {"step_cut", note, "Time steps were cut",
     "Blocks moved farther than allowed, or contacts did not settle. The step was repeated with a smaller size.",
     "Nothing, if few steps were cut; else use a smaller time_step."},
    {"step_in_parts", note, "Load steps were made in parts",
     "A load step of elastoplastic rock found equilibrium only in four or more parts. It is near a limit load, or "
     "too long.",
     "Nothing, if a limit load is near; else use more load steps (load_steps)."},
    {"step_moves_far", note, "Blocks move far in a step",
     "A block moved farther than allowed_displacement_ratio times half the size of the scene in one step.",
     "Nothing, if blocks fly freely; else use a smaller time_step, or step_control=error."},
    {"step_passes_blocks", warning, "A block may have passed through others",
     "In one step a block moved farther than the side of a square with the mean area of a block. Contacts on this "
     "path are not seen.",
     "Use a smaller time_step."},
    {"step_unresolved", warning, "Controlled steps are not resolved",
     "Parts of a step have the least size, least_step_share times time_step. Their error or displacement is still "
     "larger than requested.",
     "Use a smaller time_step or least_step_share, or a greater step_tolerance."},
    {"strained_beyond_linear", warning, "Linear statics was used for a large strain",
     "An element of an NMM body carries a stress above a tenth of its modulus. Linear statics assumes small "
     "strains.",
     "Check the units of loads and modulus; for large strains use --set motion=dynamic --set start=sudden."},
    {"sunk_beyond_limit", error, "Blocks lie too deep in one another",
     "Depth over the size of the smaller block, or common area at the end over its area, exceeds penetration_limit "
     "(0.1).",
     "Use a smaller time_step or stiffer contacts (contact_penalty)."},
    {"tension_without_strength", error, "Contacts without tensile strength carry tension",
     "Under profile legacy a block hangs by more than half its weight on contacts without tensile strength, in more "
     "than half of the frames. Shi's rules let contacts pull until their faces are apart by a share of the scene.",
     "Use --profile standard."},
    {"tip_without_factors", warning, "A crack tip has no stress intensity factors",
     "No domain of elements about the tip is free of other lines, loads and edges. tips.csv has neither K nor J for "
     "it.",
     "Set a smaller tip_side of the mesh."},
    {"tip_without_room", error, "A crack tip could not be judged",
     "No domain of elements about the tip is free of other lines, so that it has no stress intensity factors. "
     "Whether the crack extends is not known.",
     "Set a smaller tip_side of the mesh."},
    {"tips_still_go_on", error, "A crack still extends at the end of the run",
     "In statics each step extends a crack by one increment. A tip exceeds its toughness under the loads of the "
     "last step.",
     "Make more steps (--set steps=N)."},
    {"turned_in_a_step", error, "Contacts rotated a block by a large angle in a step",
     "In one step a block rotated by more than 0.5 rad beyond its own spin. The step does not resolve the impact or "
     "overlap that it met.",
     "Use a smaller time_step."},
    {"unbalanced_steps", error, "Forces are out of balance in many steps",
     "Contact forces leave more than 1e-4 of the largest load out of balance. This holds in more than a tenth of "
     "the steps, and in at least four.",
     "Use a smaller time_step or softer contacts, and remove slivers (slivers=glue)."},
    {"unsettled_step_accepted", warning, "A step was accepted with unsettled contacts",
     "Contacts still opened or closed in the last of eight open–close iterations. With quirk.fixed_pass_bound and a "
     "pass_limit other than 8 such steps are accepted, as in the Berkeley program.",
     "Set pass_limit=8, which does not accept such steps, or use --profile standard."},
});

}  // namespace

std::span<const Diagnostic> of_runs() {
  return kRuns;
}

}  // namespace keyblock::diagnostic_rows
