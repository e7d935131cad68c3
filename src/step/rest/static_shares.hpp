// Equilibria at growing shares of the loads.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "step/time/standard_step.hpp"

namespace keyblock {

/// A load step that is to be made.
struct LoadStep {
  int made = 0;         ///< steps before it
  double from = 0;      ///< time
  double to = 0;        ///< time
  bool is_new = false;  ///< no step was made yet on a scene that is not the first
};

/// The equilibrium under all loads at `time`; of soft bodies that is sought in parts of the loads where it is not found
/// at once. `most_iterations`: of each search.
StandardStep first_equilibrium(StandardScene& scene, const Motion& motion, double time, int most_iterations);

/// Loads grow in equal shares over the first steps; the scene is left at the share that was reached. Where neither they
/// nor held points changed since the last step, its equilibrium holds. `motion`: at the end of that.
StandardStep static_equilibrium(StandardScene& scene, const Motion& motion, const LoadStep& step);

}  // namespace keyblock
