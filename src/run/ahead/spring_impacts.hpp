// Looks at impacts that contact springs stop (impact = springs) before the run: what damping takes, and whether the step
// resolves the springs.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/error.hpp"
#include "run/prepare.hpp"

namespace keyblock {

/// Speed after over speed before an impact of a square block on a rigid floor, as the springs of its two corners and its
/// own strain have it, by integration of both in time.
struct SpringImpact {
  double mass = 0;              ///< per unit thickness
  double stiffness = 0;         ///< of both springs [force/length]
  double strain_stiffness = 0;  ///< of the corners against the centroid [force/length]
  double damping_time = 0;      ///< damping over stiffness of the strain [time]

  double rebound() const;
};

/// Warnings `springs_unresolved` and `strain_damping_takes_rebound` at `place`; none unless springs stop impacts in
/// time.
Warnings spring_impacts(const Prepared& prepared, const Place& place);

}  // namespace keyblock
