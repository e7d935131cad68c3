// Rows of warnings by the cutting of drawings into blocks and elements.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "base/words/diagnostics_parts.hpp"

namespace keyblock::diagnostic_rows {
namespace {

using enum DiagnosticLevel;

constexpr auto kCuts = std::to_array<Diagnostic>({
    {"block_inside_block", note, "A closed loop lies inside a block",
     "The loop is cut out of the block around it. Shi's programs count its area twice.",
     "Nothing, if the loop is a block or a hole of its own."},
    {"bolt_in_one_block", warning, "Both ends of a bolt lie in one block",
     "A bolt acts between two blocks; with both ends in one block it carries no force. Lines of a bolt symbol (a "
     "plate, a head) on the layer of bolts are read as bolts too.",
     "Draw the bolt across a joint, or move lines of symbols to another layer."},
    {"bolts_not_written", warning, "The cover file holds no bolts",
     "The format of cover files has no bolts. Those of the drawing are left out.",
     "Keep the drawing or a case file with the bolts, and mesh it in the run (section `covers`)."},
    {"bridge_lines_removed", note, "Lines with the same block on both sides were removed",
     "Such lines connect loops or parts of the drawing without dividing a block.",
     "Nothing, if the block is meant to be whole there; else extend the lines."},
    {"dangling_lines_removed", note, "Loose ends of lines were removed",
     "Ends that bound no block are cut off. Beside NMM bodies the same holds for joints that end inside DDA blocks.",
     "Nothing, if the ends are meant to be free; --join DISTANCE closes gaps."},
    {"duplicate_line", note, "A line was drawn twice",
     "The line has the same ends as an earlier one and is left out. The earlier one gives the joint material.",
     "Nothing, if the earlier joint material is right; else remove that line."},
    {"edge_node_ratio_unusual", note, "The edge-node ratio is unusual",
     "The ratio is 0, or at least 0.1. Most files have 0.001 to 0.02; at 0.1 merging removes whole blocks, and at 0 "
     "nothing is merged.",
     "Nothing, if the picture of `keyblock cut --svg` is right; else set 0.001."},
    {"edges_rerouted", note, "Edges were led through nodes beside them",
     "An edge passes a node nearer than the edge-node ratio times the scale of the drawing. It is led through that "
     "node.",
     "Nothing, if the picture is right; a smaller edge_node_ratio moves less."},
    {"fixed_line_ends_in_block", warning, "A block is fixed at one point only",
     "A fixed line holds a block where it crosses an edge. It ends inside this block, which can rotate about the "
     "one point where the line leaves it.",
     "Extend the line beyond the outline, or add a fixed point."},
    {"fixed_line_in_one_block", warning, "A fixed line crosses no edge",
     "A fixed line holds blocks where it crosses their edges. This one fixes its first point only, about which the "
     "block can rotate.",
     "Extend the line beyond the outline, or add a fixed point."},
    {"holes_not_written", warning, "The block file holds no holes",
     "The format of block files has no holes. Blocks that lie in a hole overlap the block around it.",
     "Write a case file instead, or divide the block with the hole by a joint."},
    {"merging_left_close_nodes", note, "Nodes nearer than the merging distance stay apart",
     "Merging them would make a group of nodes wider than the merging distance, 1.25 times the edge-node ratio "
     "times the scale of the drawing.",
     "Nothing, if no sliver results; else clean the drawing at the place named."},
    {"near_pieces_deleted", note, "Pieces of lines beside nodes were deleted",
     "Under near_pieces=deleted, pieces that pass a node too near or cross another piece are deleted, as by Shi's "
     "block cutter.",
     "Nothing, if Shi's results are wanted; else --set near_pieces=led_through."},
    {"nodes_merged", silent, "Crossings were merged with nodes beside them",
     "A crossing nearer to a node than 1.25 times the edge-node ratio times the scale of the drawing becomes that "
     "node.",
     "Nothing, if the picture is right; a smaller edge_node_ratio merges less."},
    {"nodes_merged_far", warning, "Merging changed the shapes of blocks",
     "A crossing was merged with a node that lies farther away than a twentieth of the width of the median block. "
     "The merging distance grows with the drawing, so that large drawings of small blocks lose short edges.",
     "Look at the picture of the cut. A smaller edge_node_ratio merges less; Shi's programs merge as this file says."},
    {"nodes_placed_otherwise", silent, "Merged nodes stand elsewhere than in Shi's cutter",
     "Merged nodes stand at the crossing that the geometry decides, not at the first one by the order of lines.",
     "Nothing; --set node_merging=in_order_found places them as Shi's cutter does."},
    {"overlapping_lines", note, "Lines cover each other in part",
     "Two lines lie along one another. Where they do, the earlier one gives the joint material.",
     "Nothing, if the earlier joint material is right; else correct the lines."},
    {"point_outside_blocks", warning, "Marks lie outside all blocks",
     "A fixed or measured point, an end of a bolt or another mark lies farther from all blocks than the merging "
     "distance. In a block file it has the block number 0. It is left out; a bolt goes with its end.",
     "Move the mark into a block; check the unit of the drawing."},
    {"points_moved", note, "Marks were moved onto the nearest block",
     "A mark lay outside all blocks, nearer to one than the merging distance. It was moved onto the outline of that "
     "block.",
     "Nothing, if the mark belongs to that block; else move it."},
    {"sliver_removed", note, "A block without area was left out",
     "Lines close a loop with fewer than three corners after merging. It bounds no area.",
     "Nothing, if the lines are meant to be one; else use a smaller edge_node_ratio."},
    {"slivers_glued", note, "Slivers were joined to neighbours",
     "A sliver is below 1 % of the mean area, or no larger than the mean and narrower than 2 % of its length. Under "
     "slivers=glue it is joined to the neighbour with the longest common side.",
     "Nothing, if the blocks named have no meaning of their own."},
    {"slivers_left_out", note, "Slivers were left out",
     "A sliver is below 1 % of the mean area, or no larger than the mean and narrower than 2 % of its length. Under "
     "slivers=leave_out it is removed, and a gap remains.",
     "Nothing, if the gaps do not matter; else use slivers=glue."},
    {"zero_length_line", note, "A line has no length",
     "Both ends of the line are the same point. It cuts nothing and is left out.",
     "Nothing, if the line has no purpose; else correct its ends."},
});

}  // namespace

std::span<const Diagnostic> of_cuts() {
  return kCuts;
}

}  // namespace keyblock::diagnostic_rows
