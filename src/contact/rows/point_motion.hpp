// How a material point moves with unknowns, whether its element is a block or hangs on covers.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "contact/rows/contact_row.hpp"
#include "model/kinematics.hpp"

namespace keyblock {

/// ∂x/∂q of a point: by the unknowns of its block, or by shares of cover functions.
struct PointMotion {
  DisplacementOperator of_block;  ///< 2 × n; n = 0 on covers
  std::vector<CoverShare> of_shared{};
};

/// (1 − s) a + s b, both points of one element.
PointMotion between(PointMotion a, const PointMotion& b, double s);

/// Points of the elements of a model in the configuration q. The map of a block is made when one of its points is first
/// asked for.
class PointMotions {
 public:
  PointMotions(const Model& model, const Reference& reference, const UnknownsTable& q);

  /// Makes the maps of these elements, repeated or not, so that several threads may ask for them; others are made when
  /// they are first asked for, by one thread.
  void prepare(const std::vector<ElementIndex>& elements);

  PointMotion of_vertex(VertexIndex v) const;
  /// Of the point that lay at `start`.
  PointMotion of_point(ElementIndex e, Point start) const;
  /// Of the point that lies at `x` now, or would if the element went on to there.
  PointMotion at_place(ElementIndex e, Point x) const;

 private:
  struct Block {
    BlockMap map;
    BlockJacobian jacobian;
  };
  Block made(ElementIndex e) const;
  const Block& block(ElementIndex e) const;

  const Model& model_;
  const Reference& reference_;
  const UnknownsTable& q_;
  mutable Table<ElementIndex, int> numbers_;  ///< of each element in the list below; −1 where its map was not made yet
  mutable std::vector<std::optional<Block>> blocks_;
};

/// Adds what a force on a point of the element does on its unknowns.
void add_force(const PointMotion& motion, ElementIndex e, Point force, UnknownsTable& loads);

/// The row of `direction` · (velocity of the point of a − velocity of the point of b).
ContactRow row_between(ElementIndex a, const PointMotion& of_a, ElementIndex b, const PointMotion& of_b,
                       Point direction);

/// The row of `direction` · velocity of a point, against what does not move.
ContactRow row_of(ElementIndex e, const PointMotion& motion, Point direction);

}  // namespace keyblock
