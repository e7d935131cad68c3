// Checks impacts stopped by contact springs (impact = springs) before the run: the rebound lost to damping, and the
// resolution of the springs by the step.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/error.hpp"
#include "model/scene/scene.hpp"

namespace keyblock {

/// Impact of a square block on a rigid floor. `rebound` returns the speed after over the speed before it. It integrates
/// the springs of two corners and the strain of the block in time.
struct SpringImpact {
  double mass = 0;              ///< per unit thickness
  double stiffness = 0;         ///< of both springs [force/length]
  double strain_stiffness = 0;  ///< of the corners relative to the centroid [force/length]
  double damping_time = 0;      ///< damping over stiffness of the strain [time]

  double rebound() const;
};

/// Returns warnings `springs_unresolved` and `strain_damping_takes_rebound` at `place`. Empty unless springs stop
/// impacts in a dynamic run.
Warnings spring_impacts(const Scene& scene, const Place& place);

}  // namespace keyblock
