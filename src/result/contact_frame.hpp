// One reported instant of a contact between two elements: where it is, how far its faces are apart, what it bears.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

#include "geometry/point.hpp"

namespace keyblock {

enum class ContactCondition { open, stick, slide };

std::string_view word_for(ContactCondition condition);

/// A point of one element against an edge, or a corner, of another. Forces per unit thickness.
struct ContactFrame {
  int element = 0;         ///< number of the element of the point, from 0
  int other = 0;           ///< number of the element of the edge, from 0
  int joint_material = 0;  ///< of the edge, index from 0
  ContactCondition condition = ContactCondition::open;
  Point position;  ///< of the point
  Point normal;    ///< unit, out of the other element, as the force of the last step had it
  double gap = 0;  ///< of the faces, positive where they are apart
  /// How far the point is from the one of the other face that it meets were both back where they lay before any load,
  /// along the tangent; 0 between two corners.
  double slip = 0;
  double normal_force = 0;  ///< of the last step, pressure positive
  double shear_force = 0;   ///< of the last step, on the element along the tangent
  int edge = -1;            ///< of the other element, by the corner at which it ends, counted through its loops from 0
  int joint_line = -1;      ///< joint of the drawing that made the edge, index from 0; -1: none, or none is known

  Point tangent() const { return {-normal.y, normal.x}; }
  /// On the element; the other one has the opposite.
  Point force() const { return normal_force * normal + shear_force * tangent(); }
};

using ContactFrames = std::vector<ContactFrame>;

/// What all contacts between two elements along one joint material bear together.
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

/// In the order of elements and materials.
std::vector<JointSum> joint_sums(const ContactFrames& contacts);

/// What all contacts along one joint of the drawing bear together. Force and opposite force have the same pressure and
/// the same shear along the tangent of their side, so that neither sum asks for a side.
struct JointLineSum {
  int joint_line = 0;      ///< from 0
  int joint_material = 0;  ///< of its first contact
  int contacts = 0;
  int closed = 0;
  int sliding = 0;
  double normal_force = 0;
  double shear_force = 0;
  double greatest_gap = 0;   ///< where the faces are farthest apart; 0: nowhere
  double greatest_slip = 0;  ///< the largest by amount, with its sign
};

/// In the order of the drawing, without contacts that none of its joints made.
std::vector<JointLineSum> joint_line_sums(const ContactFrames& contacts);

}  // namespace keyblock
