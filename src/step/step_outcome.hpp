// Reports the outcome of a step of `standard` in numbers, and the reason of a failed one in words.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "step/stepper.hpp"
#include "step/time/controlled_step.hpp"

namespace keyblock {

/// Returns the report of an accepted step at its end.
StepReport report_of(const StandardScene& scene, const Motion& motion, const State& state, const ControlledStep& made);

/// Returns the failure of a step that began from `state`.
StepFailure failure_of(const StandardScene& scene, const Motion& motion, const State& state, const StandardStep& step);

/// Explains why an NMM element was crushed to zero area; empty if none was. `drawn`: state with the areas as drawn.
std::string crushed_before(const StandardScene& scene, const State& drawn, const State& before, const State& end);

/// Names the blocks that overlap deeper than the limit, beyond the compression of their springs; empty if none do.
std::string too_deep(const StandardScene& scene, const Motion& motion, const State& end);

}  // namespace keyblock
