// After merging has moved nodes: pieces that pass a foreign node too near go through it, pieces that cross
// get a node.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "cut/lines/arrangement.hpp"
#include "cut/lines/tolerances.hpp"

namespace keyblock {

/// A piece led through a node beside it.
struct Detour {
  int line = 0;
  int node = 0;
  Point from;  ///< the nearest point of the piece
};

struct Planarized {
  Arrangement arrangement;
  std::vector<Detour> detours;
  int crossings = 0;          ///< nodes put where pieces crossed
  std::vector<Edge> deleted;  ///< pieces, as the old programs do
  bool is_settled = true;     ///< false: nodes lie so near to one another that each round makes more
};

/// Boundary pieces make detours within round-off only, as the old programs never delete them; other pieces
/// those programs delete instead, which comes to the same where the way through the node is there already,
/// and opens blocks where it is not.
Planarized planarize(Arrangement arrangement, std::size_t boundary_count, const CutTolerances& tolerances,
                     NearPieces near_pieces = NearPieces::led_through);

}  // namespace keyblock
