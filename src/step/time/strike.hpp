// Handles the impacts of a step: meeting of surfaces, jump of velocities, and removal of overlaps. Theory:
// docs/theory/06-impact.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "step/time/step_result.hpp"

namespace keyblock {

/// Step with known smooth motion.
struct SmoothStep {
  const StandardScene& scene;
  const Motion& start;
  const SmoothMotion& smooth;
  const StepRule& rule;
  double time = 0;
  double dt = 0;
  double slow = 0;          ///< speed
  double size = 0;          ///< of blocks
  std::size_t touches = 0;  ///< of the smooth motion
};

/// Contacts that close with a jump, and their normal velocity at the start of the step, negative.
struct ImpactTouches {
  Touches touches;
  std::vector<double> speeds;
};

/// Contacts of the smooth motion that take part.
struct OtherTouches {
  Touches touching;
  /// Lists the contacts that neither jump nor separation may drive into one another, for a jump that ends at these
  /// places.
  std::function<Touches(const UnknownsTable& after_jump)> not_driven_in;
};

/// Returns true if both sides belong to one body, which does not jump apart from itself: rigid motions do not change
/// such a contact.
bool is_within_one_body(const StandardScene& scene, const Touch& touch);

/// Writes velocities after the jump and positions after the separation into `step`, which holds the velocities before
/// it. Returns the energy given by moving supports.
double strike(const SmoothStep& of, ImpactTouches impacts, const OtherTouches& others, StandardStep& step);

}  // namespace keyblock
