// Which stepper steps a scene of dynamics `standard`.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "step/stepper.hpp"

namespace keyblock {

/// Throws std::invalid_argument for a scene that cannot be stepped.
std::unique_ptr<SceneStepper> scene_stepper(Scene scene);

/// As it was saved, of the same scene. Throws InputError.
std::unique_ptr<SceneStepper> restored_scene_stepper(Scene scene, Archive& saved);

/// What the books of a run hold that begins with this scene.
LedgerScope ledger_scope_of(const Scene& scene);

}  // namespace keyblock
