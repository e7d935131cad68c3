// Declares how a run with growing cracks fails, in the words of cracks.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>

#include "step/standard_stepper.hpp"

namespace keyblock {

/// Returns the failure of a step after which the bodies cannot be cut anew.
StepFailure cannot_go_on(int step, const std::exception& error);

/// Returns a failure by acceleration with the crack that cuts the accelerating part off, if one does.
StepFailure parted(StepFailure failure, const StandardStepper& now);

}  // namespace keyblock
