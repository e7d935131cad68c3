// Holds the report of one accepted step: a row of the step table.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/point.hpp"

namespace keyblock {

struct StepReport {
  int step = 0;                   ///< from 1
  double time = 0;                ///< at the end of the step
  double dt = 0;                  ///< size of the step; the smallest part, if dynamics `standard` makes it in parts
  int passes = 0;                 ///< open–close iterations, or solves of contact forces, redone attempts included
  int redos = 0;                  ///< rejected attempts, at this step or at its parts
  int fallbacks = 0;              ///< steps in which Newton's method handed contact forces to an interior-point method
  int contacts = 0;               ///< length of the contact list
  int closed = 0;                 ///< contacts not open at the last test
  int matrix_blocks = 0;          ///< elements, and pairs of elements with a contact (open or closed) or a bolt
  double penalty = 0;             ///< contact stiffness, force / length
  double displacement_ratio = 0;  ///< greatest vertex displacement over the allowed one
  double greatest_penetration = 0;  ///< of the closed contacts, length, ≥ 0
  double penetration_share = 0;     ///< greatest penetration over the size of the smaller element, ≥ 0
  double area_share = 1;            ///< least area of an element over that in the unloaded scene, or more than 1
  int crushed_element = 0;          ///< number of that element
  /// Dynamics `shi`: largest relative residual of the step's linear solves; `standard`: unbalanced force over the
  /// largest load on a block.
  double residual = 0;
  int residual_element = 0;  ///< number of the element at the contact with the largest residual, from 1; 0: unknown
  int residual_other = 0;    ///< of the other one
  Point residual_at;         ///< place of the contact
  int parts = 1;             ///< parts of a load step of elastoplastic rock
  std::vector<double> residuals = {};  ///< of such a step: unbalanced over largest force, before each Newton iteration
                                       ///< of its last part and after the last
  int unresolved_parts = 0;            ///< made at the least size, with a greater error or displacement than the target
  int locked_overlaps = 0;             ///< of impacts, left because other contacts block them (dynamics `standard`)
  int unsettled_contacts = 0;          ///< contacts that still opened or closed in the last iteration (if accepted)
};

}  // namespace keyblock
