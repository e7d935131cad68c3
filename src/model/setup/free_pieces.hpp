// Which pieces of a continuum its supports leave free to move, and how: what makes a static problem have no answer.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/segment.hpp"
#include "model/continuum.hpp"

namespace keyblock {

/// Elements that hang together and can move as a rigid body.
struct FreePiece {
  int body = 0;  ///< index from 0
  Point middle;  ///< mean of its elements' corners
  Eigen::Vector3d
      way;  ///< a motion that nothing hinders: shift x and y of the middle, turn times the piece's size; length 1
  std::optional<Segment> cut = std::nullopt;  ///< ends of the crack or joint that parts it from the rest of its body
};

std::vector<FreePiece> free_pieces(const Continuum& continuum);

/// "body 2, about (1, 2), can move along (1, 0)", or "can turn", or both; why, and what helps.
std::string to_string(const FreePiece& piece);

}  // namespace keyblock
