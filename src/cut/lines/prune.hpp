// Removes every piece that bounds nothing: dangling ends, and bridges between loops.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cut/lines/arrangement.hpp"

namespace keyblock {

struct Pruning {
  std::vector<Edge> kept;
  std::vector<Edge> dangling;  ///< pieces of trees hanging on the rest, or lying alone
  std::vector<Edge> bridges;   ///< pieces joining two loops: the same face on both sides
};

/// What is left does not depend on the order of the edges: an edge stays if and only if it lies on a closed
/// chain.
Pruning prune(const Arrangement& arrangement);

}  // namespace keyblock
