// Weight of every element, acting at its centroid.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "terms/body_force.hpp"

namespace keyblock {

void add_body_force(const StepContext& context, System& system) {
  const auto& [model, state, settings, dt] = context;
  for (ElementIndex e : indices(model.elements)) {
    const Element& element = model.elements[e];
    const BlockMaterial& material = model.material_of(element);
    const double weight =
        settings.quirks.weight_of_first_material ? material.density * settings.gravity : material.unit_weight;
    const Eigen::Vector2d force(0, -weight * state.elements[e].moments.area);
    system.load_of(e.value) += element.basis->constant.transpose() * force;
  }
}

}  // namespace keyblock
