// The choice between the dynamics.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "step/stepper.hpp"

namespace keyblock {

/// The stepper of the scene's dynamics. Throws std::invalid_argument for a scene that these dynamics cannot move.
std::unique_ptr<Stepper> stepper_for(Scene scene);

/// The stepper as it was saved, of the same scene; its start is not searched again. Throws InputError.
std::unique_ptr<Stepper> restored_stepper(Scene scene, Archive& archive);

}  // namespace keyblock
