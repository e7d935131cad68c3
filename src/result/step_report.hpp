// What one accepted step says of itself: the row of the step table.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/point.hpp"

namespace keyblock {

struct StepReport {
  int step = 0;                   ///< from 1
  double time = 0;                ///< at the end of the step
  double dt = 0;                  ///< size of the step; the smallest part, where dynamics `standard` makes it in parts
  int passes = 0;                 ///< open-close passes, or solves of contact forces, redone attempts included
  int redos = 0;                  ///< attempts thrown away: before this one was accepted, or of its parts
  int fallbacks = 0;              ///< steps in which Newton left contact forces to a detour by the interior
  int contacts = 0;               ///< length of the contact list
  int closed = 0;                 ///< contacts not open after the last judgement
  int matrix_blocks = 0;          ///< elements, and pairs of elements with a contact (open too) or a bolt
  double penalty = 0;             ///< contact stiffness, force / length
  double displacement_ratio = 0;  ///< greatest vertex displacement over the allowed one
  double greatest_penetration = 0;  ///< of the closed contacts, length, ≥ 0
  double penetration_share = 0;     ///< greatest of theirs over the size of the smaller element, ≥ 0
  double area_share = 1;            ///< least area of an element over that of the unloaded scene, or more than 1
  int crushed_element = 0;          ///< number of that element
  /// Dynamics `shi`: largest relative residual of the step's linear solves; `standard`: forces out of balance over the
  /// largest load on a block.
  double residual = 0;
  int residual_element = 0;  ///< number of the element at the contact that holds the residual up, from 1; 0: none told
  int residual_other = 0;    ///< of the other one
  Point residual_at;         ///< where they touch
  int parts = 1;             ///< that a load step of rock that may yield was made in
  std::vector<double> residuals = {};  ///< of such a step: out of balance over the largest force, before each round of
                                       ///< Newton's method of its last part and after the last
  int unresolved_parts = 0;            ///< made at the least size, with a greater error or displacement than wanted
  int locked_overlaps = 0;             ///< of impacts, left because other touches are in the way (dynamics `standard`)
  int unsettled_contacts = 0;          ///< contacts that still opened or closed in the last pass (accepted by choice)
};

}  // namespace keyblock
