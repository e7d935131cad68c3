// Removes every piece that bounds nothing: free ends, and bridges between loops.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cut/lines/arrangement.hpp"

namespace keyblock {

struct Pruning {
  std::vector<Edge> kept;
  std::vector<Edge> dangling;  ///< pieces of trees that are attached to the rest, or isolated
  std::vector<Edge> bridges;   ///< pieces joining two loops: the same face on both sides
};

/// Returns the kept and removed edges, whose sets do not depend on the order of the edges. An edge is kept if and only
/// if it lies on a closed chain.
Pruning prune(const Arrangement& arrangement);

}  // namespace keyblock
