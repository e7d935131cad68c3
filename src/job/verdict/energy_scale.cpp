// Sums the weights of the elements that can move.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/verdict/energy_scale.hpp"

#include <cmath>

#include "model/body_load.hpp"

namespace keyblock {

double work_of_weight(const Prepared& prepared, const Frame& first) {
  const Model& model = prepared.scene.model;
  double weight = 0;
  for (const ElementIndex e : indices(model.elements)) {
    const auto i = static_cast<std::size_t>(e.value);
    if (i >= first.elements.size() || !model.elements[e].can_move()) continue;
    weight +=
        first.elements[i].area * weight_per_area(model.material_of(model.elements[e]), prepared.scene.settings).norm();
  }
  return weight * kWayOfWeight * std::sqrt(model.mean_area);
}

}  // namespace keyblock
