// Modulus by plane, stress by height.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/material_stress.hpp"

#include "material/elastic.hpp"

namespace keyblock {

Eigen::Matrix3d modulus_of(const BlockMaterial& material, Plane plane) {
  return plane == Plane::stress ? plane_stress_modulus(material) : plane_strain_modulus(material);
}

Stress start_stress(const BlockMaterial& material, const Stress& gradient, double y) {
  const Stress& s = material.initial_stress;
  return {s.xx + y * gradient.xx, s.yy + y * gradient.yy, s.xy + y * gradient.xy};
}

}  // namespace keyblock
