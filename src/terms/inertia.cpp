// Mass matrix from the area moments, and its share of the step.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "terms/inertia.hpp"

#include "base/loop.hpp"

namespace keyblock {

// T = T0 + X Tx + Y Ty about the centroid, where first moments vanish.
UnknownBlock mass_matrix(const Basis& basis, const Moments& moments, double density) {
  const auto& [t0, tx, ty, rotation] = basis;
  const UnknownBlock mixed = tx.transpose() * ty;
  UnknownBlock mass = moments.area * (t0.transpose() * t0);
  mass += moments.xx * (tx.transpose() * tx);
  mass += moments.yy * (ty.transpose() * ty);
  mass += moments.xy * (mixed + mixed.transpose());
  return density * mass;
}

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
