// Follows the chain of scenes.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/scene/scene.hpp"

#include <algorithm>

#include "model/continuum.hpp"

namespace keyblock {

bool may_yield(const Scene& scene) {
  return scene.model.continuum &&
         std::ranges::any_of(scene.model.continuum->materials,
                             [](const BlockMaterial& material) { return material.is_nonlinear(); });
}

std::vector<const Scene*> scenes_of(const Scene& first) {
  std::vector<const Scene*> scenes{&first};
  while (scenes.back()->next) scenes.push_back(&scenes.back()->next->scene);
  return scenes;
}

}  // namespace keyblock
