// Texts of warnings before the first step: about blocks, contacts, units and outputs.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "base/sentences/sentences.hpp"

namespace keyblock {
namespace {

constexpr const char* kImplausible =
    "{what} {value:.4g} is {si:.3g} {unit} in the declared units ({units}), which is not plausible: {least:g} to "
    "{most:g} is expected";

constexpr auto kSentencesAhead = std::to_array<Sentence>({
    {"angle_in_radians",
     "a friction angle of {angle:.4g} degrees would be {meant:.3g} degrees, were it in radians: angles of friction "
     "are in degrees"},
    {"angle_in_radians:of_dilation",
     "dilation_deg {angle:.4g} with friction_deg {friction:.4g} would be {meant:.3g} degrees, were it in radians: "
     "both angles are in degrees"},
    {"block_cannot_bend",
     "{count:#block} {are} too slender for uniform strain, first block {element} at {x}, {y}, {length:p3} long and "
     "{width:p3} wide: it cannot bend[{rigid:?}, and with two fixed points it is rigid]"},
    {"block_outside_outline",
     "{count:#block} {lie} of {blocks} outside the boundary lines, the first is block {element} at {x}, {y}, area "
     "{area:p3} ({percent_of_mean:.3g} % of the mean): joints that are drawn beyond the outline make blocks there"},
    {"bonded_crack_faces",
     "the faces of the crack that ends at {x}, {y} are bonded: joint material {joint_material} has the cohesion "
     "{cohesion} and the tensile strength {tensile_strength}: K is that of bonded faces as long as the bonds hold; a "
     "joint material without both leaves the crack open"},
    {"bonded_crack_faces:of_new",
     "the faces of cracks that start are bonded: joint material {joint_material} has the cohesion {cohesion} and the "
     "tensile strength {tensile_strength}: K is that of bonded faces as long as the bonds hold; a joint material "
     "without both leaves the crack open"},
    {"contacts_thinned",
     "contacts.csv, joints.csv and joint_lines.csv would have {rows:.3g} rows and more; beyond {most:g} they hold one "
     "frame of {every} (--contacts all: every frame; none or chosen: less)"},
    {"free_blocks",
     "{count:#block} without contact {move} freely from the start, first block {element} at {x}, {y}, area {area:p3} "
     "({percent_of_mean:.3g} % of the mean)"},
    {"gravity_points_upward",
     "gravity points upward, {gravity:.4g} along y: a positive `gravity` of a file points downward"},
    {"history_of_distant_blocks",
     "history \"contact {history}\": blocks {element} and {other} are {apart} apart before any load, farther than the "
     "smaller of them is large; its forces are 0 until they meet"},
    {"implausible_density", kImplausible},
    {"implausible_density:unit_weight",
     "density {value:.4g} is {si:.3g} kg/m3 in the declared units, which is not plausible; as a unit weight in kN/m3 "
     "it would be that of rock, whose density is {of_rock:.4g} kg/m3"},
    {"implausible_gravity", kImplausible},
    {"implausible_gravity:of_another_unit",
     "gravity {value:.4g} is that of the earth in {unit}, but {si:.3g} m/s2 in the declared units ({units}): it is "
     "{of_earth:.4g} there"},
    {"implausible_modulus", kImplausible},
    {"implausible_size",
     "the scene is {width} by {height} {unit}, which is not plausible: {least:g} to {most:g} m is expected; "
     "coordinates in another unit need --unit (DXF drawing) or `units` (case file)"},
    {"implausible_strength:above_modulus",
     "a strength of {strength:.4g} under uniaxial compression is above youngs_modulus {youngs_modulus:.4g}: nothing "
     "reaches it, unless one of them is in another unit"},
    {"implausible_strength:weak",
     "a strength of {strength:.4g} under uniaxial compression is {ratio:.1g} of youngs_modulus "
     "{youngs_modulus:.4g}: no rock is so weak, unless one of them is in another unit"},
    {"joint_materials_differ",
     "{pairs} of one joint {have} different joint materials on both sides, first of blocks {element} and {other} near "
     "{x}, {y}: that of one side counts, there joint material {joint_material}"},
    {"point_outside_its_block",
     "{count:#point} {lie} outside the block that the file names, the first is {noun} of block {element} at {x}, {y}, "
     "{distance:p3} from it: it moves with the block as if it were a part of it"},
    {"rock_may_lock",
     "Poisson's ratio {poissons_ratio} in plane strain makes a mesh with {functions} functions too stiff: "
     "displacements are too small by some per cent to a half, less on a finer mesh{advice}"},
    {"slivers",
     "{count:#block} of {blocks} {are} {rule}: the smallest is block {element} at {x}, {y}, area {area:p3} "
     "({percent_of_mean:.3g} % of the mean); the thinnest is block {thinnest} at {thinnest_at}, {width:p3} wide and "
     "{length:p3} long. Slivers need small steps and may never come to rest"},
    {"springs_stiff_for_step",
     "contact springs of {stiffness:.3g} are {ratio:.3g} times as stiff as the inertia of the mean block over a step "
     "(mass / time_step²); with {pairs} pairs in contact and a ratio above {limit:g}, steps with sliding contacts may "
     "take tens to hundreds of linear solves; {remedy} avoids that"},
    {"springs_unresolved",
     "impact=springs: the step of {time_step:p3} is too long for {body} {element} (mass {mass:p3}) on its contact "
     "springs (stiffness {stiffness:p3}): omega dt is {ratio:p3}, beyond {limit:g}, so that rebounds and forces of "
     "blows depend on the step; time_step={resolved_step:.2g} resolves a blow, or "
     "contact_penalty={resolved_penalty:.2g}"},
    {"strain_damping_takes_rebound",
     "impact=springs: {damping} takes most of a rebound: {body} {element}, dropped on a rigid floor, rises to about "
     "{height:.2g} of the height at small steps, without it to {undamped_height:.2g}; {remedy} leaves the rebound to "
     "the springs"},
    {"strength_without_bond",
     "joint material {joint_material} has the cohesion {cohesion} and the tensile strength {tensile_strength}, but "
     "{pairs} with it {are} drawn up to {apart:p3} apart, first of blocks {element} and {other} near {x}, {y}: there "
     "neither acts; only faces drawn within {limit:p3} of each other are bonded"},
    {"strength_without_bond:nowhere",
     "joint material {joint_material} has the cohesion {cohesion} and the tensile strength {tensile_strength}, but no "
     "two of its faces touch at the start: neither acts anywhere"},
    {"tables_large",
     "tables of histories and measured points will take about {megabytes:.2g} MB: histories.csv {of_histories:.2g} MB "
     "of {histories} histories, history.csv and points.csv {of_points:.2g} MB of {points:#measured point}"},
    {"toe_wedged",
     "{toes} on the floor in front of it, the first of block {element} near {x}, {y}: a rigid toe cannot be pushed "
     "into the floor, and so holds what would slide on the face that dips to it by {dip_deg:p3} degrees"},
    {"unheld_blocks",
     "{count:#block} of {blocks} {are} connected to no fixed block, first block {element} at {x}, {y}, area {area:p3} "
     "({percent_of_mean:.3g} % of the mean): under gravity they fall freely"},
    {"unheld_blocks:weightless",
     "{count:#block} of {blocks} {are} connected to no fixed block, first block {element} at {x}, {y}, area {area:p3} "
     "({percent_of_mean:.3g} % of the mean): they move as loads push them"},
    {"unsupported_blocks",
     "{count:#block} {have} no support from below, first block {element} at {x}, {y}, area {area:p3} "
     "({percent_of_mean:.3g} % of "
     "the mean): friction and bonds alone can carry {them}"},
});

}  // namespace

std::span<const Sentence> sentences_ahead() {
  return kSentencesAhead;
}

}  // namespace keyblock
