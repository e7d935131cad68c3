// Computes the initial state of a scene by the rule that its settings choose. Theory:
// docs/theory/07-initial-state-and-statics.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "result/start_report.hpp"
#include "step/scene/standard_scene.hpp"

namespace keyblock {

struct InitialMotion {
  Motion motion;
  std::string failure;  ///< reason why there is no initial state; empty if there is one
  StartReport report;
};

/// Returns the initial state under the loads of t = 0. Each lot (lots.hpp) has its own method and tolerances.
InitialMotion initial_motion(const StandardScene& scene);

}  // namespace keyblock
