// Adds mass and stiffness of every element, divided by the step.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/terms/damping.hpp"

#include "legacy/terms/elastic.hpp"
#include "terms/mass_matrix.hpp"

namespace keyblock {

void add_damping(const StepContext& context, System& system) {
  const auto& [model, state, settings, dt] = context;
  for (ElementIndex e : indices(model.elements)) {
    const Element& element = model.elements[e];
    const BlockMaterial& material = model.material_of(element);
    const Moments& moments = state.elements[e].moments;
    const double of_mass = settings.mass_damping.of(element.material) / dt;
    const double of_stiffness = settings.stiffness_damping.of(element.material).value_or(0) / dt;
    system.matrix.add(e.value, e.value,
                      of_mass * mass_matrix(*element.basis, moments, material.density) +
                          of_stiffness * stiffness_matrix(*element.basis, moments.area, material, settings));
  }
}

}  // namespace keyblock
