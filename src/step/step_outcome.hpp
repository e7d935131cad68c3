// What a step of `standard` came to, in words and numbers.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "step/stepper.hpp"
#include "step/time/controlled_step.hpp"

namespace keyblock {

/// Of an accepted step, at its end.
StepReport report_of(const StandardScene& scene, const Motion& motion, const State& state, const ControlledStep& made);

/// Of one that failed, from this state.
StepFailure failure_of(const StandardScene& scene, const Motion& motion, const State& state, const StandardStep& step);

/// Why an element on covers was crushed to nothing; empty where none was. `drawn`: the areas of the start.
std::string crushed_before(const StandardScene& scene, const State& drawn, const State& before, const State& end);

/// Which blocks lie deeper in one another than the limit allows, beyond what their springs are pressed; empty where
/// none do.
std::string too_deep(const StandardScene& scene, const Motion& motion, const State& end);

}  // namespace keyblock
