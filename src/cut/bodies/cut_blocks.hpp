// Cuts a drawing into blocks: finds crossings, merges them, prunes loose ends, traces faces and places the marks.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cut/bodies/body_graph.hpp"
#include "cut/bodies/cut_result.hpp"
#include "problem/drawing.hpp"

namespace keyblock {

/// Returns the blocks of a drawing in the order and with the starting vertices of Shi's programs. Throws InputError if
/// the lines enclose no block.
CutResult cut_blocks(const Drawing& drawing, NodeMerging merging = NodeMerging::nearest_first,
                     NearPieces near_pieces = NearPieces::led_through);

struct BodyCut {
  CutResult blocks;
  BodyGraph graph;  ///< bodies are the blocks
};

/// Cuts the same blocks, but keeps joints that end inside them as slits; `cut_blocks` removes these. An end that passes
/// the last line by less than the merging distance is an overshoot, not a slit.
BodyCut cut_bodies(const Drawing& drawing, NodeMerging merging = NodeMerging::nearest_first,
                   NearPieces near_pieces = NearPieces::led_through);

}  // namespace keyblock
