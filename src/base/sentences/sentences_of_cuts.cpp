// Texts of warnings about cutting: lines, nodes, marks, slivers.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "base/sentences/sentences.hpp"

namespace keyblock {
namespace {

constexpr auto kSentencesOfCuts = std::to_array<Sentence>({
    {"block_inside_block",
     "a closed loop lies inside block {element}: it is cut out there (Shi's programs count its area twice)"},
    {"bolt_in_one_block", "both ends of the bolt{named} lie in one block: it holds nothing"},
    {"bolt_in_one_block:glued",
     "both ends of the bolt{named} lie in one block since slivers are glued: it holds nothing"},
    {"bolt_in_one_block:several",
     "both ends of {count} bolts lie in one block: they hold nothing; the first is the bolt{named} from ({x:r}, "
     "{y:r}) to ({x2:r}, {y2:r})"},
    {"bridge_lines_removed",
     "removed: {count:#piece} of {lines:#line}, which have the same block on both sides; the first is of this line"},
    {"dangling_lines_removed", "loose ends of {count} of {lines:#line} are removed; this is the first"},
    {"dangling_lines_removed:of_joints",
     "{count:#piece} of joints that end inside blocks {are} removed; in NMM bodies they are kept as cracks"},
    {"duplicate_line",
     "line {line} repeats an earlier line and is left out; the joint material is that of the earlier one"},
    {"duplicate_line:several",
     "lines {lines} repeat earlier lines and are left out; the joint material is that of the earlier one"},
    {"edges_rerouted", "{count} pieces pass a node nearer than {within:.6g} and are led through it"},
    {"ends_joined",
     "1 end of a line is joined to a near line; the farthest moved by {distance:p3}, at ({x:p6}, {y:p6})"},
    {"ends_joined:several",
     "{count} ends of lines are joined to near lines; the farthest moved by {distance:p3}, at ({x:p6}, {y:p6})"},
    {"ends_stop_short",
     "1 end of a line stops less than {within:p3} short of another line and meets it nowhere, the nearest {gap:p3} "
     "at ({x:p6}, {y:p6}), line {line}; --join DISTANCE joins those nearer than it"},
    {"ends_stop_short:several",
     "{count} ends of lines stop less than {within:p3} short of another line and meet it nowhere, the nearest "
     "{gap:p3} at ({x:p6}, {y:p6}), line {line}, the farthest {farthest:p3}; --join DISTANCE joins those nearer "
     "than it"},
    {"ends_trimmed",
     "1 end that passes a line is cut off at it; the farthest moved by {distance:p3}, at ({x:p6}, {y:p6})"},
    {"ends_trimmed:several",
     "{count} ends that pass a line are cut off at it; the farthest moved by {distance:p3}, at ({x:p6}, {y:p6})"},
    {"fixed_line_ends_in_block",
     "1 block can rotate: a fixed line ends inside it, the first at ({x}, {y}), and fixes only the point where it "
     "crosses the outline"},
    {"fixed_line_ends_in_block:several",
     "{count} blocks can rotate: a fixed line ends inside them, the first at ({x}, {y}), and fixes only the point "
     "where it crosses the outline"},
    {"fixed_line_in_one_block",
     "the fixed line from ({x:r}, {y:r}) to ({x2:r}, {y2:r}) crosses no edge: it fixes only its first point, about "
     "which the block can rotate"},
    {"merging_left_close_nodes",
     "{count} nodes stay apart from a neighbour nearer than {within:.6g}, because the group would grow wider than "
     "that; the first is ({x:.9g}, {y:.9g})"},
    {"near_pieces_deleted",
     "removed: {count:#piece} of {lines:#line}, which pass a node too near, or cross another, by the rule of Shi's "
     "programs,; the first is of this line"},
    {"nodes_merged", "{count:#crossing} moved to a node nearer than {within:.6g}, the first from ({x:.9g}, {y:.9g})"},
    {"nodes_merged_far",
     "{count:#crossing} moved by more than {percent_of_width:g} % of the width of a block ({width:p3}), the "
     "farthest by {distance:p3} from ({x:p6}, {y:p6})"},
    {"nodes_placed_otherwise",
     "{count:#node} merged at a place set by the geometry, not at the first crossing that Shi's programs find"},
    {"overlapping_lines", "the line partly covers line {other_line}; the joint material is that of the earlier one"},
    {"overlapping_lines:several",
     "{pairs} pairs of lines cover each other in part, first this line and line {other_line}; the joint material "
     "is that of the earlier one"},
    {"point_outside_blocks", "{noun} ({x:r}, {y:r}) lies outside all blocks and is left out"},
    {"point_outside_blocks:in_block_0", "{noun} in block 0, that is in none, is left out"},
    {"point_outside_blocks:several",
     "{kinds} lie outside all blocks and are left out: the first is {noun} ({x:r}, {y:r})"},
    {"point_outside_elements", "a {noun} in element 0, that is in none, is left out"},
    {"points_moved",
     "{kinds} outside all blocks, by less than {within:.3g}, {are} moved onto the nearest: the first is {noun} "
     "({x:r}, {y:r})"},
    {"sliver_removed", "the lines close a block without an area; it is left out"},
    {"slivers_glued",
     "{count:#block} of {blocks}, {percent_of_area:.2g} % of all area, {are} {rule}, and {treated} joined to the "
     "neighbour with the longest common side (slivers = glue)[; {stay}]: at {places}"},
    {"slivers_left_out",
     "{count:#block} of {blocks}, {percent_of_area:.2g} % of all area, {are} {rule}, and {treated} left out "
     "(slivers = leave_out): at {places}"},
    {"zero_length_line", "the line has no length and is left out"},
    {"zero_length_line:cuts_nothing", "a line without length cuts nothing and is left out"},
});

}  // namespace

std::span<const Sentence> sentences_of_cuts() {
  return kSentencesOfCuts;
}

}  // namespace keyblock
