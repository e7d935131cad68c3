// Adds mass times the given acceleration, at the centroid of every element.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/terms/body_acceleration.hpp"

#include "model/body_load.hpp"

namespace keyblock {

void add_body_acceleration(const StepContext& context, System& system) {
  const auto& [model, state, settings, dt] = context;
  const Eigen::Vector2d acceleration = body_acceleration_at(settings, state.time + dt);
  for (ElementIndex e : indices(model.elements)) {
    const Element& element = model.elements[e];
    const double mass = model.material_of(element).density * state.elements[e].moments.area;
    system.load_of(e.value) += element.basis->constant.transpose() * (mass * acceleration);
  }
}

}  // namespace keyblock
