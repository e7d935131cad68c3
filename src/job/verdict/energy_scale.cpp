// Sums weights, and energies of the initial stress, of the elements that can move.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/verdict/energy_scale.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "material/material_stress.hpp"
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

double least_energy(const Prepared& prepared, const Frame& first) {
  const Model& model = prepared.scene.model;
  const Plane plane = prepared.scene.settings.plane;
  double energy = 0;
  for (const ElementIndex e : indices(model.elements)) {
    const auto i = static_cast<std::size_t>(e.value);
    if (i >= first.elements.size() || !model.elements[e].can_move()) continue;
    const BlockMaterial& material = model.material_of(model.elements[e]);
    const ElementFrame& element = first.elements[i];
    const Eigen::Vector3d stress =
        in_plane(start_stress(material, material.stress_gradient, element.centroid.y, plane));
    if (stress.isZero(0)) continue;
    energy += element.area / 2 * stress.dot(modulus_of(material, plane).inverse() * stress);
  }
  return std::max(energy, work_of_weight(prepared, first));
}

}  // namespace keyblock
