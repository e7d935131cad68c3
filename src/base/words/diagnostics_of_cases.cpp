// Rows of warnings about a case before its first step: geometry, materials, loads, settings and scene.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/words/diagnostics_parts.hpp"

namespace keyblock::diagnostic_rows {
namespace {

using enum DiagnosticLevel;

constexpr auto kCases = std::to_array<Diagnostic>({
    {"angle_in_radians", warning, "An angle looks like one in radians",
     "A friction angle is above 0 and below 1.57, or a dilation angle is below 1 while friction is above 10. Angles "
     "are in degrees.",
     "Give the angle in degrees, or with its unit (\"0.5 rad\" in a case file)."},
    {"block_cannot_bend", warning, "A slender block cannot bend",
     "The block is more than five times as long as wide on average, and has at least half the median area of free "
     "blocks. The strain of a DDA block is uniform.",
     "Model it with NMM covers (section `covers`), or cut it into shorter blocks."},
    {"block_material_clamped", warning, "A block material does not exist",
     "The number of a block material is outside the list of the analysis. The nearest number of the list is taken.",
     "Correct the number, or add the block material to the analysis."},
    {"block_outside_outline", warning, "Blocks lie outside the boundary lines",
     "Joints drawn beyond the outline close blocks there.",
     "Shorten the joints; in a DXF drawing a closed boundary cuts them off."},
    {"blocks_overlap", warning, "Blocks overlap in the input",
     "Two blocks share more than 1 % of the area of the smaller one. Contact pushes them apart, or ignores the "
     "overlap.",
     "Correct the outlines of the blocks named."},
    {"bolt_broken_at_start", error, "A bolt is broken before the first step",
     "The pretension of the bolt is not below its strength.", "Give a smaller pretension or a greater strength."},
    {"bolt_strength_without_effect", warning, "The strength of bolts has no effect",
     "Under profile legacy bolts never break, as in Shi's programs.",
     "Use --profile standard, under which bolts break."},
    {"bolt_type_clamped", warning, "A bolt type does not exist",
     "The type of a bolt is outside the list bolt_properties. The nearest type of the list is taken.",
     "Correct the type, or add it to bolt_properties."},
    {"bolts_without_effect", warning, "Bolts have no effect",
     "NMM bodies whose contact is ignored, or with excavations in section `covers`, are solved by linear statics. "
     "It knows no bolts.",
     "Set `contact` of the section `covers` to felt, and excavate by `stages`."},
    {"bolts_without_properties", warning, "Bolts have neither stiffness nor pretension",
     "A bolt with stiffness 0 and pretension 0 carries no force. Bolts of four numbers in a geometry file are such "
     "bolts, unless the analysis gives their properties.",
     "Give stiffness, strength and pretension in bolt_properties of the analysis."},
    {"bonded_crack_faces", warning, "The faces of a crack are bonded",
     "Contact is felt, and the joint material of a crack, or of a joint that ends in rock, has cohesion or tensile "
     "strength. Its faces hold together, and K is that of a bonded crack until the bonds break.",
     "Give the crack a joint_material without cohesion and tensile strength."},
    {"chain_off_boundary", warning, "A chain of loads leaves the boundary",
     "Part of a chain of tractions or prescribed displacements lies on no edge of a body, by more than 1e-6 of its "
     "length. That part acts on nothing.",
     "Move the points of the chain onto the outline, or end the chain where the body ends."},
    {"contact_damping_without_effect", note, "Contact damping has no effect",
     "The analysis file gives a contact damping, which no profile reads.",
     "Nothing, if no damping is needed; else --set stiffness_damping=TIME."},
    {"contact_felt", warning, "Contact is not ignored in this run",
     "The section `covers` sets contact to ignored. Only linear statics can ignore contact; these steps resolve it.",
     "Set `contact` to felt, or use linear statics (velocity_carry_over 0, no stages, all blocks on covers)."},
    {"contact_without_effect", warning, "Bodies pass through each other",
     "Excavations of the section `covers` are solved by linear statics, which knows no contact. Bodies and the two "
     "sides of a joint pass through each other.",
     "Excavate by `stages`, which resolve contact, or set `contact` to ignored."},
    {"damping_without_effect", note, "The damping of block materials has no effect",
     "The analysis file gives block materials a damping, which no profile reads.",
     "Nothing, if no damping is needed; else --set mass_damping.N or stiffness_damping.N for material N."},
    {"dilation_above_friction", warning, "Dilation is above friction",
     "The dilation angle of a strength is above its friction angle. Plastic flow then creates energy.",
     "Give a dilation angle of at most the friction angle."},
    {"free_blocks", note, "Blocks move freely from the start",
     "These blocks have neither contact nor bolt. In a dynamic run they fall or fly.",
     "Nothing, if this is meant; else close the gaps of the drawing."},
    {"free_without_gravity", note, "No block is fixed, and there is no gravity",
     "The geometry has no fixed points, and the analysis gives neither gravity nor unit weights. Blocks move freely.",
     "Nothing, if the scene is meant to move freely; else add fixed points or fixed lines."},
    {"functions_lock", warning, "Derived functions lock in plastic flow",
     "NMM bodies with a strength and functions derived cannot flow without change of volume. Limit loads come out "
     "far too high: 64 % in a footing of Tresca rock with 1,006 unknowns.",
     "Set `functions` of the section `covers` to constant (1.4 % there)."},
    {"gravity_points_upward", warning, "Gravity points upward",
     "gravity.y is positive. A positive `gravity` of a file points downward.", "Change the sign of gravity."},
    {"history_of_distant_blocks", note, "A history follows blocks that lie apart",
     "Two blocks of a contact history are farther apart before any load than the smaller one is large. The forces "
     "are 0 until they meet.",
     "Nothing, if the blocks will meet; else check their numbers in the picture."},
    {"horizontal_force_without_effect", warning, "Horizontal body forces have no effect on blocks",
     "The analysis gives a horizontal force per volume. It acts on elements of a cover file only.",
     "Use --set gravity.x=VALUE or --set body_acceleration.x=VALUE."},
    {"implausible_closure_strain", warning, "Cracks of the rock close at an implausible strain",
     "closure_strain of the material is above 0.1. Cracks of rock close at a strain of 0.01 or less.",
     "Give the strain as a number, not in per cent."},
    {"implausible_density", warning, "A density is not plausible in the declared units",
     "Expected are 100 to 25000 kg/m³. A density that would be the unit weight of rock in kN/m³, 15 to 35, is named as "
     "such.",
     "Correct the density or `units`; density is mass per volume."},
    {"implausible_gravity", warning, "Gravity is not plausible in the declared units",
     "Expected are 0.01 to 1000 m/s², and not the gravity of the earth in another unit than the declared one.",
     "Correct the gravity or `units`."},
    {"implausible_modulus", warning, "A modulus is not plausible in the declared units",
     "Young's modulus of rock, soil and masonry is expected to be 1e4 to 1e12 Pa.",
     "Correct youngs_modulus or `units`."},
    {"implausible_size", warning, "The scene is not of plausible size in the declared units",
     "The larger extent of the scene is expected to be 0.03 to 5000 m.",
     "Correct `units` of the case, or give the unit of a DXF drawing by --unit."},
    {"implausible_strength", warning, "Strength and modulus are not plausible together",
     "The strength under uniaxial compression is expected to lie between 1e-7 of Young's modulus and the modulus.",
     "Give both values in the same unit."},
    {"initial_strain_without_effect", note, "Initial strains have no effect",
     "The analysis file gives initial strains, which move nothing, as in the Berkeley program.",
     "Nothing, if none are needed; else give an initial stress."},
    {"initial_velocity_without_effect", warning, "Initial velocities have no effect",
     "Under profile legacy, blocks start with the values of the stress gradient, as in the Berkeley program.",
     "Use --set quirk.start_velocity_slots=off, or --profile standard."},
    {"joint_material_clamped", warning, "A joint material does not exist",
     "The number of a joint material is outside the list of the analysis. The nearest number of the list is taken.",
     "Correct the number, or add the joint material to the analysis."},
    {"joint_materials_differ", warning, "A joint has two joint materials",
     "Two faces that lie side by side have joint materials of different strength. That of the face on which the corner "
     "of the other lies counts. In a block, the joint material at a corner is that of the edge that arrives there.",
     "Give both faces the same joint material."},
    {"loading_points_without_load", warning, "Loading points carry no load",
     "The analysis has fewer load curves than the geometry has loading points. The last points carry no load.",
     "Add the missing curves, or remove the points."},
    {"matching_without_associated_flow", warning, "The cone is not matched to this flow",
     "Matching plane_strain assumes dilation equal to friction. Other dilation gives another limit load in plane "
     "strain.",
     "Set dilation_deg to friction_deg, or use surface mohr_coulomb."},
    {"matching_without_effect", warning, "The matching of a strength has no effect",
     "Only the surface drucker_prager reads `matching`.", "Remove `matching`, or use surface drucker_prager."},
    {"mesh_error_at_points", note, "Errors of stress at loaded points do not count",
     "The stress has no limit at a point that carries a force. Within a quarter of the first mesh's side of it, "
     "errors are left out of the estimate.",
     "Nothing, if stress at these points does not matter; else spread the force as a traction."},
    {"mesh_error_not_reached", warning, "The mesh does not reach the requested error",
     "Refinement by error ended above the value of mesh.error, or no finer mesh confirmed the estimate. It ends "
     "after 60 refinements, at most_unknowns, or if sides can be no shorter.",
     "Raise most_unknowns of the mesh, or request a greater error."},
    {"motion_applied", note, "The ground motion accelerates all blocks",
     "The table of motion is multiplied by gravity and accelerates all blocks. The Berkeley program reads such "
     "tables and never applies them.",
     "Nothing, if the motion is meant to act; else leave out its file."},
    {"motion_of_one_gravity", warning, "Block materials have different gravities",
     "The table of motion is a multiple of gravity, which is unit weight over density. Materials differ in it by "
     "more than 0.1 %; that of the first is taken.",
     "Give the analysis a gravity, or correct unit_weight and density."},
    {"no_fixed_points", warning, "No block is fixed",
     "The geometry has no fixed points, and no section `covers` supports it. The blocks have no support.",
     "Add fixed points or fixed lines, unless the scene is meant to move freely."},
    {"over_relaxation_without_effect", silent, "The over-relaxation factor has no effect",
     "The analysis file gives an over-relaxation factor. The equations are solved directly.", "Nothing."},
    {"overlaps_not_looked_for", note, "Some overlaps of blocks were not checked",
     "Many corners lie close together. The search for overlaps ended before it had compared all pairs, and found "
     "none.",
     "Nothing, if the picture shows no overlaps; else simplify crowded outlines."},
    {"point_outside_its_block", warning, "A point lies outside the block that the file names",
     "The block file names the block of a fixed, loading or measured point. The point lies outside it by more than "
     "0.001 of the root of the mean area. It moves with the block.",
     "Correct the point or its block number."},
    {"points_without_effect", warning, "Fixed and loading points have no effect",
     "NMM bodies whose contact is ignored, or with excavations in section `covers`, are solved by linear statics. "
     "It knows neither fixed nor loading points.",
     "Give `displacements` and `forces` in the section `covers`."},
    {"rock_may_lock", warning, "Nearly incompressible rock locks",
     "NMM bodies in plane strain have a Poisson's ratio of 0.49 or more, and constant or derived functions. Such "
     "functions cannot keep their area and bend: a cantilever of 2.5 sides over its depth is 3 % too stiff at 0.49, 9 "
     "% "
     "at 0.499 and 22 % at 0.4999 with derived functions.",
     "Set functions of the section `covers` to linear, or refine the mesh until displacements stay."},
    {"setting_without_effect", warning, "A setting has no effect in this run",
     "No part of this run reads the setting. The message says which runs do.",
     "Remove the setting; `keyblock run --settings` lists what reads each."},
    {"slivers", warning, "Some blocks are slivers",
     "A block is below 1 % of the mean area, or no larger than the mean and narrower than 2 % of its length. Slivers "
     "need small steps and may never come to rest.",
     "--set slivers=glue joins them to neighbours; slivers=leave_out removes them."},
    {"soft_patterns", note, "Short waves of elastoplastic NMM bodies are too slow",
     "Gradients of constant functions are averaged over covers and hardly see motion that alternates from cover to "
     "cover. Velocities of single points after an impact are wrong; smooth motion and energy are right.",
     "Nothing, if no point is followed through an impact."},
    {"softening_without_fracture_energy", warning, "Softening depends on the mesh",
     "The strength decreases with plastic strain, and no fracture_energy is given. Finer meshes then soften faster.",
     "Give `after` a fracture_energy instead of a plastic_strain."},
    {"springs_stiff_for_step", note, "Contact springs are stiff for the time step",
     "At least 500 pairs of blocks touch, and contact_penalty exceeds 100 times the mean mass over time_step². "
     "Steps in which contacts slide may take tens to hundreds of linear solves.",
     "Nothing, if the run is fast enough; else use a smaller contact_penalty or time_step."},
    {"springs_unresolved", warning, "The time step is too long for the contact springs",
     "Under impact=springs the lightest free body has the frequency ω = √(2 contact_penalty / mass). If ω time_step "
     "exceeds 1, a blow lasts fewer than four steps, and rebound depends on the step.",
     "Use a time_step of π/(20 ω), or a smaller contact_penalty."},
    {"stage_without_effect", warning, "Part of a stage changes nothing",
     "An excavation, a cut, a change of material, a removed bolt or a release of the stage meets nothing.",
     "Correct its outline, line or number."},
    {"strain_damping_takes_rebound", warning, "Damping of strain takes the rebound",
     "Under impact=springs, damping of strain takes energy that the springs would return. The estimated rebound "
     "speed of the lightest free body is below 95 % of that without damping.",
     "Use strain_damping=none (or stiffness_damping=0), or impact=jump with restitution."},
    {"strength_without_bond", warning, "Cohesion and tensile strength do not act",
     "Faces whose joint material has cohesion or tensile strength are drawn apart by more than 1e-4 of block size, or "
     "none of them meets another. Only faces that meet at the start are bonded.",
     "Draw the faces together, or cut the blocks by joints; else set cohesion and tensile_strength to 0."},
    {"surplus_load_curves", warning, "Load curves have no loading point",
     "The analysis has more load curves than the geometry has loading points. The last curves are ignored.",
     "Add the missing points, or remove the curves."},
    {"tables_large", warning, "Tables of results will be large",
     "Histories and measured points will fill 100 MB or more: histories.csv, history.csv and points.csv, by the "
     "number of steps.",
     "Follow fewer points. Beyond 5,000 steps, tables keep every n-th step by themselves."},
    {"tensile_strength_without_effect", warning, "A tensile strength has no effect",
     "The tensile strength is above the apex of the yield surface, c cot φ.",
     "Give a lower tensile_strength, or remove it."},
    {"toe_wedged", warning, "A sharp toe rests on the floor in front of it",
     "The face on which rock could slide comes out where the slope meets its floor, and a rigid toe cannot be pushed "
     "into a rigid floor. A bench has a factor of 2.66 this way, and 0.92 if the face comes out 0.3 m above the floor. "
     "Limit equilibrium, which lets the toe pass, gives 0.91.",
     "Let the face come out a little above the floor, or cut the toe off, if the rock there can be crushed."},
    {"unheld_blocks", warning, "Blocks are not connected to a support",
     "Neither contacts nor bolts connect these blocks with a fixed block. They fall under gravity, or move as loads "
     "push them.",
     "Close the gaps of the drawing, or fix the blocks."},
    {"unit_weight_without_effect", warning, "A unit weight has no effect",
     "A unit weight differs from density times gravity by more than 0.1 %. Density times gravity is used, as in the "
     "Berkeley program.",
     "Correct unit_weight or density, or --set quirk.weight_of_first_material=off."},
    {"unsupported_blocks", note, "Blocks have no support from below",
     "No chain of blocks beneath leads from these blocks to a support. Friction, bonds and wedging alone can carry "
     "them.",
     "Nothing, if this is meant, as in a roof or an arch."},
    {"zero_length_bolt", warning, "A bolt has no length",
     "Both ends of the bolt are the same point. It has no direction and is left out.", "Correct the ends of the bolt."},
});

}  // namespace

std::span<const Diagnostic> of_cases() {
  return kCases;
}

}  // namespace keyblock::diagnostic_rows
