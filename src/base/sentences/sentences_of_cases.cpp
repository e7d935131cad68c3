// Texts of warnings about cases: checks, materials, preparation, conversion.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "base/sentences/sentences.hpp"

namespace keyblock {
namespace {

constexpr const char* kClamped = "{noun} {number} of {count} {carriers} is outside 1 to {last}; taken as {taken}";

constexpr auto kSentencesOfCases = std::to_array<Sentence>({
    {"block_material_clamped", kClamped},
    {"blocks_overlap",
     "block {element} lies in block {other} by {percent_of_smaller:.3g} % of the smaller one[; so do "
     "{at_least}{other_pairs:#other pair}]: contact drives them apart, or lets them be"},
    {"bolt_broken_at_start",
     "bolt {bolt}{named} is broken from the start: its pretension of {pretension:g} is not below its strength of "
     "{bolt_strength:g}"},
    {"bolt_type_clamped", kClamped},
    {"bolts_without_properties",
     "{count} of {bolts:#bolt} {have} neither stiffness nor pretension and {carry} no force; bolts of a drawing "
     "take these from `bolt_properties` of the analysis"},
    {"bolts_without_properties:of_stage",
     "{count:#bolt} of a stage have neither stiffness nor pretension and carry no force"},
    {"chain_off_boundary",
     "{off:.6g} of the {length:.6g} of this chain lies off the boundary of the bodies, first from ({x:.6g}, "
     "{y:.6g}) on, and acts on nothing; move its points onto the outline"},
    {"comments_dropped", "{count} {comments} not carried over"},
    {"dialect_changes", "profile legacy has other rules for the written dialect: {changed}"},
    {"dilation_above_friction",
     "dilation_deg {dilation_deg:r} is above friction_deg {friction_deg:r}{when}: flow then creates energy"},
    {"edge_node_ratio_unusual",
     "edge-node ratio {ratio:r} is not between 0 and {most:r}; files usually have 0.001 to 0.02"},
    {"first_steps_fail", "a run fails: {why}"},
    {"implausible_closure_strain",
     "closure_strain {closure_strain:.4g} is above {most:r}: cracks of rock close at a hundredth or less; is it in "
     "per cent?"},
    {"joint_material_clamped", kClamped},
    {"loading_points_without_load",
     "{curves} load curves for {loading_points} loading points; points without one carry no load"},
    {"matching_without_associated_flow",
     "matching plane_strain assumes associated flow; with dilation_deg {dilation_deg:r} and friction_deg "
     "{friction_deg:r} the limit load in plane strain is not that of mohr_coulomb"},
    {"matching_without_effect", "only drucker_prager reads matching: with this surface it has no effect"},
    {"mesh_error_at_points",
     "the stress has no limit at {count:#point} that {carry}, the first of them ({x:r}, {y:r}): within "
     "{radius:.2g} of it, a quarter of the first mesh's side, errors do not count"},
    {"mesh_error_not_reached",
     "the stresses of the mesh are estimated to be off by {error:.2g} of the energy norm, more than the permitted "
     "error of {permitted:.2g}: {obstacle}"},
    {"mesh_error_not_reached:unconfirmed",
     "the stresses of the mesh are estimated to be off by {error:.2g} of the energy norm, and no finer mesh "
     "confirms it: {obstacle}"},
    {"motion_applied",
     "the ground motion, times a gravity of {gravity:r}, accelerates all blocks; the Berkeley program reads it and "
     "does not apply it"},
    {"motion_of_one_gravity",
     "{count} of {materials} block materials have another gravity, weight over mass; the motion takes that of the "
     "first"},
    {"one_material_a_block",
     "{count} of {blocks} blocks hold elements of several materials and take that of the first"},
    {"poor_fit",
     "R² is {r_squared:.3g}, and {neighbours} neighbouring points lie off the fit by {percent_of_greatest:.2g} % "
     "of the greatest stress on average: the curve does not follow the data, and errors and intervals mean nothing"},
    {"profile_changes",
     "without --profile, a run takes profile {profile} for the written files and {profile_before} for those read: "
     "--profile {profile_before} keeps to that"},
    {"setting_without_effect", "setting {setting} has no effect here: it {why}"},
    {"setting_without_effect:no_side",
     "setting {setting} has no effect here: it finds {slivers:#sliver}, {rule}, but none that shares a side with "
     "another"},
    {"setting_without_effect:no_sliver", "setting {setting} has no effect here: it finds no block {rule}"},
    {"several_cases",
     "a second {noun} of {count}, after {file}: together the files are no case, each was looked at alone"},
    {"soft_patterns",
     "elastoplastic NMM bodies have soft patterns in dynamics: gradients are averaged over {covers} covers and "
     "hardly see motion that alternates from cover to cover. About three in four of {vibrations} vibrations are "
     "too slow. Smooth motion and energy are right, velocities of single points after an impact are not"},
    {"softening",
     "stress falls from {peak:.4g} at strain {strain:.4g} to {last:.4g} at the end: the fitted law has a plateau "
     "and does not soften"},
    {"softening_without_fracture_energy",
     "strength decreases with plastic strain, without a fracture_energy: results depend on the mesh"},
    {"surplus_load_curves", "{curves} load curves for {loading_points} loading points; the surplus is ignored"},
    {"tensile_strength_without_effect",
     "tensile_strength {tensile_strength:r} is above the apex of the surface, c cot φ = {apex:.4g}{when}: it has "
     "no effect"},
});

}  // namespace

std::span<const Sentence> sentences_of_cases() {
  return kSentencesOfCases;
}

}  // namespace keyblock
