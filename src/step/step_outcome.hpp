// Reports the outcome of a step of `standard` and the reason of a failed one, as values.
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

/// Adds the last area of an NMM element that was crushed to zero area, if one was. `drawn`: state with the areas as
/// drawn. Returns true if its law softens under compression.
bool add_crushed_before(const StandardScene& scene, const State& drawn, const State& before, const State& end,
                        Facts& facts);

/// Names the blocks that overlap deeper than the limit, beyond the compression of their springs; empty if none do.
Finding too_deep(const StandardScene& scene, const Motion& motion, const State& end);

}  // namespace keyblock
