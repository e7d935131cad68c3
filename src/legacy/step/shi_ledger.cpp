// Energies and momenta block by block, from what the state carries.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/step/shi_ledger.hpp"

#include <Eigen/LU>
#include <cmath>

#include "material/material_stress.hpp"
#include "model/body_load.hpp"
#include "terms/mass_matrix.hpp"

namespace keyblock {
namespace {

// ½ A σᵀ D⁻¹ σ; D is isotropic, so that the frame of the stress is of no account.
double strain_energy(const BlockMaterial& material, Plane plane, const ElementState& now) {
  const Eigen::Vector3d stress(now.stress.xx, now.stress.yy, now.stress.xy);
  return now.moments.area / 2 * stress.dot(modulus_of(material, plane).inverse() * stress);
}

}  // namespace

LedgerRow stored_row(const Model& model, const Settings& settings, const State& state, const StartPlaces& unloaded) {
  const Point centre = stored_scope(unloaded).centre;
  LedgerRow row;
  row.step = state.step;
  row.time = state.time;
  for (ElementIndex e : indices(model.elements)) {
    const Element& element = model.elements[e];
    const BlockMaterial& material = model.material_of(element);
    const ElementState& now = state.elements[e];
    const Placement& first = unloaded.elements[e];
    const Point moved = now.centroid - first.centroid;
    row.stored.strain += strain_energy(material, settings.plane, now);
    row.stored.gravity -=
        first.moments.area * weight_per_area(material, settings).dot(Eigen::Vector2d(moved.x, moved.y));
    const Unknowns v = end_velocity(now, state, settings, element.material);
    const Unknowns p = mass_matrix(*element.basis, now.moments, material.density) * v;
    if (p.size() == 0) continue;
    const Point linear{p[0], p[1]};
    const Point arm = now.centroid - centre;
    row.stored.kinetic += v.dot(p) / 2;
    row.momentum += {linear, cross(arm, linear) + p[2]};
    row.momentum_size.linear += length(linear);
    row.momentum_size.angular += length(arm) * length(linear) + std::abs(p[2]);
  }
  return row;
}

LedgerScope stored_scope(const StartPlaces& unloaded) {
  Point sum;
  for (const Placement& element : unloaded.elements) sum = sum + element.centroid;
  return {false, true, (1 / static_cast<double>(unloaded.elements.size())) * sum};
}

}  // namespace keyblock
