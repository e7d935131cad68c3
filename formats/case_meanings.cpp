// The table, in the order of case_fields.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/case_meanings.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace keyblock::formats {
namespace {

constexpr auto kMeanings = std::to_array<CaseMeaning>({
    {"case.units", "names of the base units; one consistent set for all numbers, nothing is converted"},
    {"units.length", "L; absent: not said"},
    {"units.mass", "M; absent: not said"},
    {"units.time", "T; absent: not said"},

    {"case.drawing", "lines that cut blocks, and marks on them; one geometry a file: drawing, blocks or cover"},
    {"edge_node_ratio", "crossings nearer than about this share of the scene's size become one node"},
    {"boundary_count", "how many of the joints, the first ones, are boundary lines"},
    {"drawing.joints", "lines that may become edges of blocks"},
    {"material_lines", "lines that give every block they cross their material; the last one wins"},
    {"bolts", "axial springs between two points"},
    {"fixed_lines", "where they cross edges blocks are fixed; a fixed point where both ends are equal"},
    {"loading_points", "points that carry the point_loads, in their order"},
    {"measured_points", "points that are followed in time"},
    {"hole_points", "points whose blocks are taken out"},
    {"x1", "of the start, L"},
    {"y1", "of the start, L"},
    {"x2", "of the end, L"},
    {"y2", "of the end, L"},
    {"joints.joint_material", "number of the joint material"},
    {"block_material", "number of the block material"},
    {"stiffness", "F/L"},
    {"strength", "force at which it breaks, F"},
    {"pretension", "force in it at the start, F"},
    {"type", "number of the bolt_properties, for a bolt that has none of its own"},
    {"x", "L"},
    {"y", "L, upward"},

    {"case.blocks", "blocks as cut, and points in them"},
    {"blocks.blocks", "each with its corners"},
    {"material", "number of the block material"},
    {"outer", "corners, counter-clockwise, the first not repeated"},
    {"holes", "the corners of each hole, clockwise"},
    {"outer.joint_material", "number of the joint material of the edge that arrives at the corner"},
    {"holes.joint_material", "number of the joint material of the edge that arrives at the corner"},
    {"first_block", "number of the block of the start"},
    {"second_block", "number of the block of the end"},
    {"fixed_points", "points that are held, or driven by the fixed_point_motions in their order"},
    {"block", "number of the block that carries the point"},

    {"case.cover", "elements and physical covers of the manifold method"},
    {"elements", "polygons, each with its material and its three covers, all counter-clockwise"},
    {"first", "number of the first slot of the chain"},
    {"size", "number of slots of the chain; its first stands once more behind them"},
    {"elements.material", "number of the block material; 0: none"},
    {"cover_1", "number of a physical cover"},
    {"cover_2", "number of a physical cover"},
    {"cover_3", "number of a physical cover"},
    {"vertices", "vertex slots"},
    {"nodes", "where the mathematical node of each physical cover lies"},
    {"loops", "contact loops, chains of loop_vertices: outer ones counter-clockwise, holes clockwise"},
    {"loop_vertices", "corners of the contact loops"},
    {"slot", "number of the vertex slot"},
    {"loop_vertices.joint_material", "number of the joint material of the edge that leaves the corner"},
    {"element", "number of the element that carries the point"},

    {"case.analysis", "controls of the run, materials, loads in time"},
    {"dialect", "of the old program whose file it was: decides some rules of profile legacy"},
    {"velocity_carry_over", "share of the velocities taken into the next step: 0 static, 1 dynamic"},
    {"step_count", "number of time steps"},
    {"time_step", "the step, or its upper limit where it is automatic, T"},
    {"allowed_displacement_ratio", "displacement allowed in a step over half the greater extent of the scene"},
    {"automatic_time_step", "profile legacy: whether the program chooses the step"},
    {"automatic_penalty", "profile legacy: whether the program adapts the contact stiffness"},
    {"contact_penalty", "contact stiffness, F/L; absent: penalty_factor times the largest Young's modulus"},
    {"penalty_factor", "contact stiffness over the largest Young's modulus"},
    {"plane_strain", "true: plane strain; false: plane stress"},
    {"analysis.rotation", "how blocks turn in profile legacy"},
    {"gravity", "downward, L/T²; where given, the weight is density times this; absent: the unit weights"},
    {"open_close_limit", "most passes of the open-close iteration in a step"},
    {"open_close", "constants of the open-close iteration"},
    {"closing_ratio", "penetration that closes a contact, over half the greater extent of the scene"},
    {"opening_ratio", "separation that opens a contact, over half the greater extent of the scene"},
    {"allowed_penetration", "penetration the automatic penalty aims at, over half the greater extent of the scene"},
    {"angle_overlap_deg", "edges within this angle count as parallel, degrees"},
    {"normal_to_shear_stiffness", "stiffness of a contact, normal over shear"},
    {"contact_damping", "kept from old files, without effect"},
    {"over_relaxation", "of the solver of the old program, without effect; absent: not said"},
    {"save_interval", "steps between two frames, more where a run would leave more than 100; absent: 1"},
    {"block_materials", "numbered from 1 in their order; at least one"},
    {"density", "mass per area, M/L²"},
    {"unit_weight", "weight per area, downward, F/L²; 0: weightless"},
    {"youngs_modulus", "F/L²"},
    {"poissons_ratio", "below 0.5 in plane strain"},
    {"damping", "kept from old files, without effect"},
    {"horizontal_force", "force per area in x, F/L²; acts on elements of a cover only"},
    {"initial_stress", "at y = 0, tension positive"},
    {"stress_gradient", "change of the initial stress per y"},
    {"initial_velocity", "of the centroid, and rate of rotation"},
    {"initial_strain", "kept from old files, without effect"},
    {"initial_stress.xx", "F/L²"},
    {"initial_stress.yy", "F/L²"},
    {"initial_stress.xy", "F/L²"},
    {"stress_gradient.xx", "F/L³"},
    {"stress_gradient.yy", "F/L³"},
    {"stress_gradient.xy", "F/L³"},
    {"initial_velocity.x", "L/T"},
    {"initial_velocity.y", "L/T"},
    {"initial_velocity.rotation", "1/T, counter-clockwise"},
    {"initial_strain.xx", "1"},
    {"initial_strain.yy", "1"},
    {"initial_strain.xy", "1"},
    {"joint_materials", "numbered from 1 in their order; at least one"},
    {"friction_angle_deg", "degrees"},
    {"cohesion", "F/L²"},
    {"tensile_strength", "F/L²"},
    {"bolt_properties", "for bolts of a drawing that state none of their own, by their type"},
    {"fixed_point_motions", "displacement in time of each fixed point; an empty list: held"},
    {"point_loads", "force in time on each loading point; fewer than points: the others carry none"},
    {"body_acceleration", "of all blocks in time, linear between rows"},
    {"time", "T, greater than in the row before"},
    {"fixed_point_motions.x", "displacement, L"},
    {"fixed_point_motions.y", "displacement, L"},
    {"point_loads.x", "F"},
    {"point_loads.y", "F"},
    {"body_acceleration.x", "L/T²"},
    {"body_acceleration.y", "L/T²"},

    {"motion", "ground motion in time"},
    {"motion.x", "acceleration over gravity"},
    {"motion.y", "acceleration over gravity"},

    {"frames", "results: how everything stood at instants of a run; a new run takes no notice of them"},
    {"step", "number of the step"},
    {"frames.time", "since the start, T; 0 in all frames where the file they are from has none"},
    {"frames.elements", "blocks or elements"},
    {"elements.loops",
     "corners of the outer loop, counter-clockwise, then of each hole, clockwise; three each at least"},
    {"elements.x", "of the centroid, L"},
    {"elements.y", "of the centroid, L"},
    {"displacement_x", "since the start, L"},
    {"displacement_y", "since the start, L"},
    {"rotation", "since the start, rad, counter-clockwise"},
    {"velocity_x", "L/T"},
    {"velocity_y", "L/T"},
    {"velocity_rotation", "1/T, counter-clockwise"},
    {"stress_xx", "F/L², tension positive"},
    {"stress_yy", "F/L², tension positive"},
    {"stress_xy", "F/L²"},
    {"area", "L²"},
    {"mass", "per unit thickness, M; 0: not known"},
    {"moment_of_inertia", "about the centroid, per unit thickness, M L²; 0: not known"},
    {"frames.bolts", "where they stood, and what they carried"},
    {"force", "tension positive, F"},
    {"is_broken", "whether it has broken"},
    {"frames.fixed_points", "where they stood"},
    {"frames.loading_points", "where they stood"},
    {"frames.measured_points", "where they stood"},
    {"tracks", "results: the ways of measured points; a new run takes no notice of them"},
    {"point", "number of the measured point"},
    {"rows", "one at the end of each step"},
    {"rows.time", "since the start, T"},
    {"rows.time_step", "length of the step, T"},
    {"displacement", "since the start, L"},
    {"speed", "L/T"},

    {"run", "what a run of this file takes unless its command says otherwise"},
    {"profile", "name of the preset of all choices; absent: standard"},
    {"set", "settings on top of the profile, as `keyblock run --set`; `keyblock run --settings` lists them"},
});

}  // namespace

std::span<const CaseMeaning> case_meanings() {
  return kMeanings;
}

std::string_view meaning_of(std::string_view parent, std::string_view key) {
  const std::string full = std::string(parent) + '.' + std::string(key);
  for (const std::string_view wanted : {std::string_view(full), key}) {
    const auto found = std::ranges::find(kMeanings, wanted, &CaseMeaning::key);
    if (found != kMeanings.end()) return found->meaning;
  }
  return {};
}

}  // namespace keyblock::formats
