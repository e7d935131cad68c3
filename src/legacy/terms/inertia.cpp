// Adds the mass of each element, and its velocity, for a constant acceleration over the step.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/terms/inertia.hpp"

#include "base/loop.hpp"
#include "terms/mass_matrix.hpp"

namespace keyblock {

void add_inertia(const StepContext& context, System& system) {
  const Model& model = context.model;
  const State& state = context.state;
  const Settings& settings = context.settings;
  const double dt = context.dt;
  for_each_index(model.elements, [&](ElementIndex e) {
    const Element& element = model.elements[e];
    const ElementState& now = state.elements[e];
    const double carry_over = settings.velocity_carry_over.of(element.material);
    const UnknownBlock mass = mass_matrix(*element.basis, now.moments, model.material_of(element).density);
    system.matrix.add(e.value, e.value, 2 / (dt * dt) * mass);
    system.load_of(e.value) += (2 / dt) * carry_over * (mass * now.velocity);
  });
}

}  // namespace keyblock
