// Removes the velocities that closing contacts leave at the end of a smooth motion. Theory: docs/theory/06-impact.md,
// 6.5.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "step/time/impact.hpp"
#include "step/time/smooth_motion.hpp"

namespace keyblock {

/// Smooth motion of a step, or of a part of it, and its contacts.
struct ClosingStep {
  const StandardScene& scene;
  const Motion& start;
  const SmoothMotion& smooth;
  const StepRule& rule;
  const Scales& scales;
  const Touches& touches;
  const std::vector<double>& speeds;  ///< per contact: normal velocity at the start; 0 if no impact is possible
  const std::vector<bool>& closed;    ///< per contact: true if it bears or bonds
  double time = 0;
  double dt = 0;
  double whole = 0;  ///< whole step, of which this is a part
};

struct CleanedVelocities {
  UnknownsTable v;
  double given = 0;     ///< energy by moving supports
  double given_up = 0;  ///< kinetic energy that NMM bodies lost
};

/// Returns the velocities at the end of the step: strain rates that it does not resolve are stopped, contacts with
/// multipliers and springs that met have no normal velocity, and supports have theirs. Where pushes gave such strain
/// rates, these are stopped last, which may leave contacts of that block a small velocity.
CleanedVelocities cleaned_up(const ClosingStep& of);

/// Returns true if the gap is above kTouching of the size of bodies.
bool is_apart(const Touch& touch, const Table<VertexIndex, Point>& vertices, double size);

}  // namespace keyblock
