// The impacts of a step: where the surfaces met, the jump of velocities, and overlaps removed.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "step/time/smooth_solve.hpp"
#include "step/time/standard_step.hpp"

namespace keyblock {

/// The step whose smooth motion is known.
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

/// Touches that close with a jump, and how fast they closed at the start of the step: normal velocity, negative.
struct ImpactTouches {
  Touches touches;
  std::vector<double> speeds;
};

/// Touches of the smooth motion that take part.
struct OtherTouches {
  Touches touching;
  /// Lists the touches that neither jump nor separation may drive into one another, for a jump that ends at these
  /// places.
  std::function<Touches(const UnknownsTable& after_jump)> not_driven_in;
};

/// A body does not jump apart from itself: rigid motions leave such a touch as it is.
bool is_within_one_body(const StandardScene& scene, const Touch& touch);

/// Puts velocities after the jump and places after the separation into `step`, whose velocities are those before.
/// Returns the energy that moving supports gave.
double strike(const SmoothStep& of, ImpactTouches impacts, const OtherTouches& others, StandardStep& step);

}  // namespace keyblock
