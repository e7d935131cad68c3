// Texts of warnings of the readers of files.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "base/sentences/sentences.hpp"

namespace keyblock {
namespace {

constexpr const char* kAbsent = "{element_name} is absent; taken as {value}";
constexpr const char* kScaled =
    "the unit of the {source} is the {unit}; coordinates are multiplied by {written} to the {unit_taken}";
constexpr const char* kIgnored = "{element_name} is ignored";

constexpr auto kSentencesOfReaders = std::to_array<Sentence>({
    {"bolt_outside_blocks", "a bolt with an end in block 0, that is in none, is left out"},
    {"bolts_with_block_numbers", "bolts have 9 numbers: their block numbers are ignored"},
    {"bolts_without_data", "{bolts} bolts are announced but the file holds none; there are none"},
    {"bolts_without_properties:in_file", "bolts have 4 numbers: stiffness, strength and pre-tension taken as 0"},
    {"default_analysistype", kAbsent},
    {"default_autopenalty", kAbsent},
    {"default_autotimestep", kAbsent},
    {"default_damping", kAbsent},
    {"default_edge_node_ratio", "no edge_node_ratio is given, {edge_node_ratio:r} is taken"},
    {"default_edge_node_ratio:of_dxf", "a DXF file has no edge-node ratio; taken as {edge_node_ratio:r}"},
    {"default_gravaccel", kAbsent},
    {"default_gravity", kAbsent},
    {"default_pfactor", "Autopenalty has no pfactor; taken as {pfactor}"},
    {"default_planestrain", kAbsent},
    {"default_rotation", kAbsent},
    {"default_unit_weight", "no unit_weight is given, {unit_weight} is taken: blocks of this material are weightless"},
    {"defaults_taken", "defaults taken: {taken}"},
    {"dxf_clipped",
     "the boundary cuts off joints that run beyond it: {shortened} are shorter now or in pieces, {removed} lay "
     "outside or along it and are gone"},
    {"dxf_curves_as_chords",
     "{curves} {kinds} are {chords} chords; none leaves its curve by more than {share_of_radius:r} of the radius[ "
     "(of an ellipse: its greater half axis), or {share_of_spline:r} of the size of a spline]"},
    {"dxf_hidden_layers",
     "{entities} on layers that are frozen or off {are} left out: {layers}[ and {more} more]; a row of --layers "
     "for such a layer takes it"},
    {"dxf_layer_as_joints",
     "layer {quoted} names no part of a drawing; its lines and curves, {count} in number, are joints of joint "
     "material {joint_material}{hint}"},
    {"dxf_layer_not_there", "on {layers} of the table nothing lies in the drawing"},
    {"dxf_not_clipped",
     "the outline is open at ({x:p6}, {y:p6})[: the nearest other end is {gap:p3} away, at ({x2:p6}, {y2:p6})]; "
     "joints are not cut off at the boundary{remedy}"},
    {"dxf_not_clipped:branched",
     "{lines} boundary lines meet at ({x:p6}, {y:p6}), 2 are expected; joints are not cut off at the boundary"},
    {"dxf_not_clipped:tangled", "too many boundary lines lie along one another to cut joints off at them"},
    {"dxf_not_clipped:too_many", "too many boundary lines and joints to cut joints off at the boundary"},
    {"dxf_old_marks",
     "{count} texts F, L, M, H on layers that name no part of a drawing: read as the old Windows program did, as "
     "fixed, loading, measured and hole points; there the joint material of a line is its colour + 1"},
    {"dxf_scaled_to_declared_unit", kScaled},
    {"dxf_scaled_to_metres", kScaled},
    {"dxf_skipped", "skipped: {count} × {entity}"},
    {"dxf_unit_overruled", "the unit of the file is {unit} ($INSUNITS {insunits}); --unit overrules it: {taken}"},
    {"dxf_unit_unknown", "$INSUNITS {insunits} is no unit known here; coordinates are taken as they are"},
    {"dxf_vertex_count", "group 90 states {stated} vertices, the LWPOLYLINE has {vertices}; these are read"},
    {"dxf_without_unit",
     "the drawing names no unit ($INSUNITS): its coordinates are taken as in {unit}, the unit of the case"},
    {"frames_missing", "{announced} frames are announced, the file holds {frames} whole ones"},
    {"joint_material_not_whole", "joint material {written} is not a whole number; taken as 0 (no material)"},
    {"pipe_flow_ignored", kIgnored},
    {"points_missing", "the file ends {points} points early; they are taken as not there"},
    {"repeated_element", "{element_name} is repeated; the last counts"},
    {"repeated_element:of_parent", "{element_name} of {parent} is repeated; the {taken} counts"},
    {"seismic_points_ignored", kIgnored},
    {"surplus_numbers", "{count} numbers behind the last record are ignored"},
    {"time_history_ignored", kIgnored},
    {"track_cut", "the rows of measured point {measured_point} are not closed by {close}; the whole ones are read"},
    {"trailing_text", "text from {quoted} on is ignored"},
    {"unknown_choice", "{attribute} of {element_name}: expected {expected}, found {found}; taken as {taken}"},
    {"unknown_element", kIgnored},
});

}  // namespace

std::span<const Sentence> sentences_of_readers() {
  return kSentencesOfReaders;
}

}  // namespace keyblock
