// Declares the choice of stepper for a scene of dynamics `standard`.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "step/stepper.hpp"

namespace keyblock {

/// Returns the stepper of the scene. Throws std::invalid_argument if no stepper supports the scene.
std::unique_ptr<SceneStepper> scene_stepper(Scene scene);

/// Restores the stepper from a checkpoint of the same scene. Throws InputError.
std::unique_ptr<SceneStepper> restored_scene_stepper(Scene scene, Archive& saved);

/// Returns the quantities that the energy balance of a run covers, if the run begins with this scene.
LedgerScope ledger_scope_of(const Scene& scene);

}  // namespace keyblock
