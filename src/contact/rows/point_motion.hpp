// Computes the motion of a material point by the unknowns of its DDA block or NMM body. Theory:
// docs/theory/01-kinematics.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "contact/rows/contact_row.hpp"
#include "model/kinematics.hpp"

namespace keyblock {

/// Derivative ∂x/∂q of a point: by the unknowns of its block, or by values of cover functions.
struct PointMotion {
  DisplacementOperator of_block;  ///< 2 × n; n = 0 for NMM bodies
  std::vector<CoverShare> of_shared{};
};

/// Returns (1 − s) a + s b, both points of one element.
PointMotion between(PointMotion a, const PointMotion& b, double s);

/// Motions of points of a model in the configuration q. The map of a block is made with the first request for one of
/// its points.
class PointMotions {
 public:
  PointMotions(const Model& model, const Reference& reference, const UnknownsTable& q);

  /// Makes the maps of these elements, which may repeat, so that several threads may request them. Other maps are made
  /// on request, by one thread only.
  void prepare(const std::vector<ElementIndex>& elements);

  PointMotion of_vertex(VertexIndex v) const;
  /// Returns the motion of the point that lay at `start`.
  PointMotion of_point(ElementIndex e, Point start) const;
  /// Returns the motion of the point that lies at `x` now, or would if the element extended to there.
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
  mutable Table<ElementIndex, int> numbers_;  ///< per element, index in `blocks_`; −1 if its map is not made yet
  mutable std::vector<std::optional<Block>> blocks_;
};

/// Adds the force on a point of the element to the loads on its unknowns.
void add_force(const PointMotion& motion, ElementIndex e, Point force, UnknownsTable& loads);

/// Returns the row of `direction` · (velocity of the point of a − velocity of the point of b).
ContactRow row_between(ElementIndex a, const PointMotion& of_a, ElementIndex b, const PointMotion& of_b,
                       Point direction);

/// Returns the row of `direction` · velocity of a point against fixed ground.
ContactRow row_of(ElementIndex e, const PointMotion& motion, Point direction);

}  // namespace keyblock
