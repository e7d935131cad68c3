// Sums contacts along joints: to pieces of joints, to pairs of bodies, or to joints of the drawing.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "formats/columns/column_filler.hpp"
#include "formats/columns/frame_part.hpp"
#include "geometry/point.hpp"

namespace keyblock::formats {

/// Contacts of one sum. `piece`: those of two bodies along one joint and joint material. `bodies`: those of two bodies
/// along one joint material. `line`: those of one joint of the drawing; all others are left out.
enum class JointsBy { piece, bodies, line };

/// Sum over contacts. A force and its opposite have the same pressure, and the same shear along the tangent of their
/// side, so all but `force` do not depend on the choice of side. Numbers count from 1; forces per unit thickness.
struct JointSum {
  int block = 0;  ///< the lower number; of a line, that of its first contact
  int other = 0;
  int joint_material = 0;  ///< of a line, that of its first contact
  int joint = 0;           ///< of the drawing; 0: none
  int contacts = 0;
  int closed = 0;
  int sliding = 0;
  double normal_force = 0;
  double shear_force = 0;
  Point force = {};          ///< on `block`, if it is the same for all contacts
  double greatest_gap = 0;   ///< where the faces are farthest apart; 0: all closed
  double greatest_slip = 0;  ///< the largest by magnitude, with its sign
  Point tangent = {};        ///< of the first contact
  Ends ends = {};            ///< the contacts that lie farthest apart along this tangent
};

/// Returns the sums of the part `contacts` of an instant, in the order of bodies, joints and materials.
std::vector<JointSum> joint_sums(const FramePart& contacts, JointsBy by);

/// Returns the part `joints` of an instant: one row per piece, with a column for each member of JointSum but `force`
/// and `tangent`.
FramePart joint_part(const FramePart& contacts);

}  // namespace keyblock::formats
