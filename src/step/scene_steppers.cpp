// Chooses the stepper of a scene: scenes without contact have steppers of their own.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/scene_steppers.hpp"

#include <utility>

#include "step/linear_stepper.hpp"
#include "step/load_stepper.hpp"
#include "step/standard_stepper.hpp"
#include "step/time/ledger.hpp"

namespace keyblock {

std::unique_ptr<SceneStepper> scene_stepper(Scene scene) {
  if (scene.is_untouched && may_yield(scene)) return std::make_unique<LoadStepper>(std::move(scene));
  if (scene.is_untouched) return std::make_unique<LinearStepper>(std::move(scene));
  return std::make_unique<StandardStepper>(std::move(scene));
}

std::unique_ptr<SceneStepper> restored_scene_stepper(Scene scene, Archive& saved) {
  if (scene.is_untouched && may_yield(scene)) return std::make_unique<LoadStepper>(std::move(scene), saved);
  if (scene.is_untouched) return std::make_unique<LinearStepper>(std::move(scene), saved);
  return std::make_unique<StandardStepper>(std::move(scene), saved);
}

LedgerScope ledger_scope_of(const Scene& scene) {
  return scene.is_untouched ? LedgerScope() : ledger_scope(standard_scene(scene));
}

}  // namespace keyblock
