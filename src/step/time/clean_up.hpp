// Removes the velocities that closing contacts leave at the end of a smooth motion. Theory: docs/theory/06-impact.md,
// 6.5.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "step/time/impact.hpp"
#include "step/time/smooth_motion.hpp"

namespace keyblock {

struct CleanedVelocities {
  UnknownsTable v;
  double given = 0;     ///< energy by moving supports
  double given_up = 0;  ///< kinetic energy that NMM bodies lost
  /// Per contact: true if it follows a law of impulses, under which it may open.
  std::vector<bool> may_open = {};
};

/// Returns the velocities at the end of the step: strain rates that it does not resolve are stopped, and supports have
/// their velocity. Contacts with multipliers and springs that met have no normal velocity, or open. Where pushes gave
/// such strain rates, these are stopped last, which may leave contacts of that block a small velocity.
CleanedVelocities cleaned_up(const ClosingStep& of);

/// Returns true if the gap is above kTouching of the size of bodies.
bool is_apart(const Touch& touch, const Table<VertexIndex, Point>& vertices, double size);

}  // namespace keyblock
