// Traces the faces of an arrangement: an outer chain counter-clockwise, and clockwise chains of holes.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cut/lines/arrangement.hpp"

namespace keyblock {

/// Node of a chain with the edge that arrives there. `half_edge` has the face on its left: 2e along edge e, 2e + 1
/// against it.
struct ChainLink {
  int node = 0;
  int line = 0;
  int half_edge = -1;
};

using Chain = std::vector<ChainLink>;

/// Face to the left of every edge of its chains. A chain passes each node once: a hole that touches the outer chain in
/// a node is a chain of its own.
struct Face {
  Chain outer;
  std::vector<Chain> holes;
};

/// Returns all bounded faces of a pruned arrangement, in the order of Shi's programs. Nodes ascend, edges around each
/// node run counter-clockwise from the x direction, and each edge adds the face to its right. A chain starts at its
/// lowest node.
std::vector<Face> trace_faces(const Arrangement& arrangement);

}  // namespace keyblock
