// Displacement and velocity of bodies on covers, carried over to what is left of them.
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

/// Where displacements may differ from those before: the elements that are not kept, and some rings about them.
struct ChangedPart {
  std::vector<int> elements;  ///< those with functions that may change, ascending
  std::vector<char> changed;  ///< of each of these, whether it is not kept
  std::vector<int> place;     ///< of each function of the bodies among those that may change; -1: it stays
  int function_count = 0;     ///< of those that may change
};
ChangedPart changed_part(const CoverScene& after, const std::vector<char>& kept);

/// `start` with what it lacks of the fields of the bodies before, which `fields` tell by points over each element of
/// the part. The velocity is projected by mass, M v = ∫ ρ Tᵀ v: that leaves a field that the functions hold as it is,
/// and of any field it keeps the momentum, for a uniform field is among them. The angular momentum of every body, about
/// which the projection of the displacement says nothing, is kept by a turning of the body. Displacements are nearest
/// in the energy of elastic rock; those of functions outside the part stay as they are to the bit. Over elements that
/// are kept `start` is the field before, over others it is a guess.
CarriedCovers carried_covers(CarriedCovers start, const ChangedPart& part,
                             std::span<const std::vector<FieldPoint>> fields, const CoverScene& after);

/// An element of a body with the box about it.
struct BoxedElement {
  Box box;
  int element = 0;
};

/// The elements of a body, those near a region found quickly.
class BoxedElements {
 public:
  BoxedElements() = default;
  explicit BoxedElements(std::vector<BoxedElement> elements);

  /// Those whose boxes overlap this one, by their numbers.
  std::vector<int> overlapping(const Box& box) const;

 private:
  std::vector<BoxedElement> from_left_;  ///< by the left sides of their boxes
  double widest_ = 0;                    ///< of the boxes
};

/// Of every body.
std::vector<BoxedElements> boxed_elements(const CoverScene& bodies);

/// The fields of a body, which has these elements, over a region of the start: exact to the product of the fields with
/// each other, and with a polynomial of `degree`.
std::vector<FieldPoint> field_over(const CoverScene& bodies, const BoxedElements& elements,
                                   std::span<const std::vector<Point>> region, int degree, const Eigen::VectorXd& d,
                                   const Eigen::VectorXd& v);

}  // namespace keyblock
