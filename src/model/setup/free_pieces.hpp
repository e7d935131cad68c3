// Finds pieces of a continuum that its supports leave free to move; with one, a static problem has no solution.
// Theory: docs/theory/07-initial-state-and-statics.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/segment.hpp"
#include "model/continuum.hpp"

namespace keyblock {

/// Connected elements that can move as a rigid body.
struct FreePiece {
  int body = 0;  ///< index from 0
  Point middle;  ///< mean of its elements' corners
  Eigen::Vector3d
      way;  ///< a motion without resistance: shift x and y of the middle, rotation times the piece's size; length 1
  std::optional<Segment> cut = std::nullopt;  ///< ends of the crack or joint that cuts it off from the rest of its body
};

std::vector<FreePiece> free_pieces(const Continuum& continuum);

/// Describes the piece: "body 2, about (1, 2), can move along (1, 0)", or "can turn", or both; then the reason and a
/// remedy.
std::string to_string(const FreePiece& piece);

}  // namespace keyblock
