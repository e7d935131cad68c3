// Follows the chain.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/scene/scene.hpp"

namespace keyblock {

std::vector<const Scene*> scenes_of(const Scene& first) {
  std::vector<const Scene*> scenes{&first};
  while (scenes.back()->next) scenes.push_back(&scenes.back()->next->scene);
  return scenes;
}

}  // namespace keyblock
