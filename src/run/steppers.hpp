// Declares the choice between the dynamics.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "step/stepper.hpp"

namespace keyblock {

/// Returns the stepper of the scene's dynamics. Throws std::invalid_argument for a scene that these dynamics cannot
/// run.
std::unique_ptr<Stepper> stepper_for(Scene scene);

/// Restores the stepper from a checkpoint of the same scene, without a new search for the start. Throws InputError.
std::unique_ptr<Stepper> restored_stepper(Scene scene, Archive& archive);

}  // namespace keyblock
