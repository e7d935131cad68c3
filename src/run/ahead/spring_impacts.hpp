// Looks before the run at impacts that contact springs stop (impact = springs): the rebound that damping takes, and
// whether the step resolves the springs.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/error.hpp"
#include "model/scene/scene.hpp"

namespace keyblock {

/// Impact of a square block on a rigid floor. `rebound` is the speed after over the speed before it, as the springs of
/// two corners and the strain of the block have it, by integration of both in time.
struct SpringImpact {
  double mass = 0;              ///< per unit thickness
  double stiffness = 0;         ///< of both springs [force/length]
  double strain_stiffness = 0;  ///< of the corners against the centroid [force/length]
  double damping_time = 0;      ///< damping over stiffness of the strain [time]

  double rebound() const;
};

/// Warnings `springs_unresolved` and `strain_damping_takes_rebound` at `place`; none unless springs stop impacts in
/// time.
Warnings spring_impacts(const Scene& scene, const Place& place);

}  // namespace keyblock
