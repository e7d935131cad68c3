// Holds one reported instant of a contact between two elements: its place, the gap of its faces, and its forces.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

#include "geometry/point.hpp"

namespace keyblock {

enum class ContactCondition { open, stick, slide };

std::string_view word_for(ContactCondition condition);

/// Contact of a point of one element with an edge, or a corner, of another. Forces per unit thickness.
struct ContactFrame {
  int element = 0;         ///< number of the element of the point, from 0
  int other = 0;           ///< number of the element of the edge, from 0
  int joint_material = 0;  ///< of the edge, index from 0
  ContactCondition condition = ContactCondition::open;
  Point position;  ///< of the point
  Point normal;    ///< unit, out of the other element, as in the force of the last step
  double gap = 0;  ///< of the faces, positive if open
  /// Distance along the tangent, in the undeformed scene, between the point and the point of the other face that it
  /// meets; 0 between two corners.
  double slip = 0;
  double normal_force = 0;  ///< of the last step, pressure positive
  double shear_force = 0;   ///< of the last step, on the element along the tangent
  int edge = -1;            ///< of the other element, by its end corner, counted through its loops from 0
  int joint_line = -1;      ///< joint of the drawing that made the edge, index from 0; -1: none or unknown

  Point tangent() const { return {-normal.y, normal.x}; }
  /// Returns the force on the element; the other one has the opposite force.
  Point force() const { return normal_force * normal + shear_force * tangent(); }
};

using ContactFrames = std::vector<ContactFrame>;

}  // namespace keyblock
