// Traces the faces of an arrangement: each an outer chain counter-clockwise and the chains of its holes
// clockwise.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cut/lines/arrangement.hpp"

namespace keyblock {

/// A node of a chain, and the edge that arrives there: its line, and the half-edge that has the face on its left
/// (2e along edge e, 2e + 1 against it).
struct ChainLink {
  int node = 0;
  int line = 0;
  int half_edge = -1;
};

using Chain = std::vector<ChainLink>;

/// The face lies to the left of every edge of its chains. A chain passes each node once: where a hole touches
/// the outer chain in a node they are two chains.
struct Face {
  Chain outer;
  std::vector<Chain> holes;
};

/// All bounded faces of a pruned arrangement, numbered as the old programs do: nodes ascending, about each
/// node its edges counter-clockwise from the x direction; each edge calls for the face to its right. A chain
/// starts at its lowest node.
std::vector<Face> trace_faces(const Arrangement& arrangement);

}  // namespace keyblock
