// Transfers displacement and velocity of NMM bodies to their remaining pieces or a new mesh.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "geometry/box.hpp"
#include "step/bodies/cover_scene.hpp"
#include "step/groups/body_group.hpp"

namespace keyblock {

struct CarriedCovers {
  Eigen::VectorXd d;
  Eigen::VectorXd v;
};

/// Part whose displacements may change: elements that are not kept, and some rings around them.
struct ChangedPart {
  std::vector<int> elements;  ///< with functions that may change, ascending
  std::vector<char> changed;  ///< per such element: true if it is not kept
  std::vector<int> place;     ///< index of each function of the bodies among those that may change; -1: unchanged
  int function_count = 0;     ///< functions that may change
};
ChangedPart changed_part(const CoverScene& after, const std::vector<char>& kept);

/// Returns `start` corrected by the fields of the earlier bodies. `fields` holds points over each element of the part;
/// `start` is the earlier field in kept elements and a guess in others. The velocity is projected by mass, M v = ∫ ρ Tᵀ
/// v. The projection leaves fields unchanged that the functions contain, and keeps the momentum of any field, because
/// uniform fields are among the functions. A rotation of each body keeps its angular momentum. Displacements are
/// nearest in the energy of elastic rock; functions outside the part keep theirs bit for bit.
CarriedCovers carried_covers(CarriedCovers start, const ChangedPart& part,
                             std::span<const std::vector<FieldPoint>> fields, const CoverScene& after);

/// Element of a body with its bounding box.
struct BoxedElement {
  Box box;
  int element = 0;
};

/// Elements of a body, with fast search near a region.
class BoxedElements {
 public:
  BoxedElements() = default;
  explicit BoxedElements(std::vector<BoxedElement> elements);

  /// Returns the numbers of elements whose boxes overlap this one.
  std::vector<int> overlapping(const Box& box) const;

 private:
  std::vector<BoxedElement> from_left_;  ///< sorted by the left sides of their boxes
  double widest_ = 0;                    ///< largest width of a box
};

/// Returns the boxed elements per body.
std::vector<BoxedElements> boxed_elements(const CoverScene& bodies);

/// Returns the fields of the body with these elements over a region of the initial shape. The points are exact for
/// products of the fields with each other, and with a polynomial of `degree`.
std::vector<FieldPoint> field_over(const CoverScene& bodies, const BoxedElements& elements,
                                   std::span<const std::vector<Point>> region, int degree, const Eigen::VectorXd& d,
                                   const Eigen::VectorXd& v);

}  // namespace keyblock
