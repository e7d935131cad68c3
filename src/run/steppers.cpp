// Chooses between Shi's rules, the standard step, a chain of its scenes, and growing cracks.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/steppers.hpp"

#include <utility>

#include "legacy/step/shi_stepper.hpp"
#include "run/growth/growth_stepper.hpp"
#include "run/growth/growth_under_loads.hpp"
#include "run/stages/chain_stepper.hpp"
#include "step/scene_steppers.hpp"

namespace keyblock {
namespace {

bool grows_under_given_loads(const Scene& scene) {
  return scene.growth && scene.growth->plan.loads == GrowthLoads::given;
}

}  // namespace

std::unique_ptr<Stepper> stepper_for(Scene scene) {
  if (grows_under_given_loads(scene)) return std::make_unique<GrowthUnderLoads>(std::move(scene));
  if (scene.growth) return std::make_unique<GrowthStepper>(std::move(scene));
  if (scene.next || scene.end.steps > 0) return std::make_unique<ChainStepper>(std::move(scene));
  if (scene.settings.dynamics == Dynamics::standard) return scene_stepper(std::move(scene));
  return std::make_unique<ShiStepper>(std::move(scene));
}

std::unique_ptr<Stepper> restored_stepper(Scene scene, Archive& archive) {
  if (grows_under_given_loads(scene)) return std::make_unique<GrowthUnderLoads>(std::move(scene), archive);
  if (scene.growth) return std::make_unique<GrowthStepper>(std::move(scene), archive);
  if (scene.next || scene.end.steps > 0) return std::make_unique<ChainStepper>(std::move(scene), archive);
  if (scene.settings.dynamics == Dynamics::standard) return restored_scene_stepper(std::move(scene), archive);
  return std::make_unique<ShiStepper>(std::move(scene), archive);
}

}  // namespace keyblock
