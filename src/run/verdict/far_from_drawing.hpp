// Measures how far a search for equilibrium moved a block, relative to the size of that block.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "model/model.hpp"
#include "result/field_frame.hpp"
#include "result/frame.hpp"

namespace keyblock {

/// Displacement over the width of a block, beyond which an equilibrium is not that of the drawing. A block that leans
/// on one corner overturns when its centroid has moved by half its width: a tenth takes a fifth of its resistance.
inline constexpr double kFarFromDrawing = 0.1;

/// Displacement over the width of a block above which it is reported: elastic settlement of rock is smaller.
inline constexpr double kSeenFromDrawing = 5e-3;

/// Block (or NMM body) that moved farthest for its width.
struct CarriedBlock {
  int number = 0;         ///< of the block, or of an element of the body, from 0
  bool is_body = false;   ///< an NMM body
  Point drawn = {};       ///< the vertex that moved farthest, before any load; of a body its centroid
  double way = 0;         ///< displacement, less `driven` [length]
  double width = 0;       ///< mean width: area over twice the distance of the farthest vertex from the centroid
  bool is_loose = false;  ///< below 1 % of the median area of free blocks: not representative of others

  double share() const { return width > 0 ? way / width : 0; }
};

/// Returns the block that moved farthest for its width; loose blocks count only if `loose`. Empty if nothing moved.
/// `end` and `field` are the same instant, of `model`. The greatest displacement prescribed by the user is subtracted,
/// because it is no response of the scene. An NMM body may bend freely, so that its mean displacement counts; those
/// with prescribed displacements are left out.
std::optional<CarriedBlock> farthest_carried(const Model& model, const Frame& end, const FieldFrame& field,
                                             bool loose = false);

}  // namespace keyblock
