// Adds the weight of every element, at its centroid.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/terms/body_force.hpp"

#include "base/loop.hpp"
#include "model/body_load.hpp"

namespace keyblock {

void add_body_force(const StepContext& context, System& system) {
  const Model& model = context.model;
  const State& state = context.state;
  const Settings& settings = context.settings;
  for_each_index(model.elements, [&](ElementIndex e) {
    const Element& element = model.elements[e];
    const Eigen::Vector2d force =
        state.elements[e].moments.area * weight_per_area(model.material_of(element), settings);
    system.load_of(e.value) += element.basis->constant.transpose() * force;
  });
}

}  // namespace keyblock
