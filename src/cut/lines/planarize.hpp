// Restores a plane arrangement after merging has moved nodes. Pieces that pass a foreign node too near are led through
// it, and pieces that cross get a node.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "cut/lines/arrangement.hpp"
#include "cut/lines/tolerances.hpp"

namespace keyblock {

/// Piece led through a node beside it.
struct Detour {
  int line = 0;
  int node = 0;
  Point from;  ///< the nearest point of the piece
};

struct Planarized {
  Arrangement arrangement;
  std::vector<Detour> detours;
  int crossings = 0;          ///< nodes put where pieces crossed
  std::vector<Edge> deleted;  ///< pieces deleted, as Shi's programs do
  bool is_settled = true;     ///< false: nodes lie so near to one another that each iteration adds more
};

/// Leads pieces through near nodes. Boundary pieces make detours within round-off only, because Shi's programs never
/// delete them. Other pieces those programs delete instead. The result is the same if the path through the node exists
/// already; if not, deletion opens blocks.
Planarized planarize(Arrangement arrangement, std::size_t boundary_count, const CutTolerances& tolerances,
                     NearPieces near_pieces = NearPieces::led_through);

}  // namespace keyblock
