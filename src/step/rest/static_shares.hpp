// Computes equilibria at growing load fractions. Theory: docs/theory/07-initial-state-and-statics.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "step/time/standard_step.hpp"

namespace keyblock {

/// Load step to be made.
struct LoadStep {
  int made = 0;         ///< steps before it
  double from = 0;      ///< time
  double to = 0;        ///< time
  bool is_new = false;  ///< true before the first step of a later scene
};

/// Returns the equilibrium under all loads at `time`. If the search fails and bodies are soft, it is repeated with load
/// increments. `most_iterations`: limit of each search.
StandardStep first_equilibrium(StandardScene& scene, const Motion& motion, double time, int most_iterations);

/// Makes a load step from `motion`, the end of the last. Loads grow in equal increments over the first steps. The scene
/// keeps the load fraction reached. If neither loads nor fixed points changed, the last equilibrium holds.
StandardStep static_equilibrium(StandardScene& scene, const Motion& motion, const LoadStep& step);

}  // namespace keyblock
