// Computes the size of the first and the next step, by rule or constant.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/state.hpp"
#include "settings/settings.hpp"

namespace keyblock {

/// Input of the rule from the last step.
struct StepHistory {
  double dt = 0;                  ///< last accepted step size
  double displacement_ratio = 0;  ///< of the last step
  double penetration = 0;         ///< greatest of the last step, length
  double penalty = 0;             ///< contact stiffness of the last step, before its adaptation
};

/// Returns the size of step 1. It reaches the allowed displacement under the greatest acceleration of weight, initial
/// stress and loads (Shi's rule; legacy-formats 3.4). `start_speed` is the largest initial velocity component.
double first_step_size(const Model& model, const State& state, const Settings& settings, double start_speed);

/// Returns the size of later steps by the same rule, from penetration and loads, at most 1.3 times the last
/// (legacy-rules 13). The mean area is that of the initial blocks, the stiffness that of the last step. This reproduces
/// the 20 steps of the Berkeley program's own example, circle slope: 69 passes, 59 contacts, end time to 1e-6. It is
/// inferred from that one run, and no other confirms it. The Berkeley program's -0.00335 on
/// tests/malformed/00_control_orig is not reproduced.
double next_step_size(const Model& model, const State& state, const Settings& settings, const StepHistory& last);

}  // namespace keyblock
