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

/// Sum over all contacts between two elements along one joint material.
struct JointSum {
  int element = 0;  ///< the lower number, from 0
  int other = 0;
  int joint_material = 0;
  int contacts = 0;
  int closed = 0;
  int sliding = 0;
  double normal_force = 0;
  double shear_force = 0;
  Point force = {};  ///< on the element
};

/// Returns the sums in the order of elements and materials.
std::vector<JointSum> joint_sums(const ContactFrames& contacts);

/// Sum over all contacts along one joint of the drawing. A force and its opposite have the same pressure, and the same
/// shear along the tangent of their side, so the sums do not depend on the choice of side.
struct JointLineSum {
  int joint_line = 0;      ///< from 0
  int joint_material = 0;  ///< of its first contact
  int contacts = 0;
  int closed = 0;
  int sliding = 0;
  double normal_force = 0;
  double shear_force = 0;
  double greatest_gap = 0;   ///< where the faces are farthest apart; 0: all closed
  double greatest_slip = 0;  ///< the largest by magnitude, with its sign
};

/// Returns the sums in the order of the drawing, without contacts on other edges than its joints.
std::vector<JointLineSum> joint_line_sums(const ContactFrames& contacts);

}  // namespace keyblock
