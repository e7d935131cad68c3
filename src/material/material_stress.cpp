// Chooses the modulus by plane and the stress by height.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/material_stress.hpp"

#include "material/elastic.hpp"

namespace keyblock {

Eigen::Matrix3d modulus_of(const BlockMaterial& material, Plane plane) {
  return plane == Plane::stress ? plane_stress_modulus(material) : plane_strain_modulus(material);
}

Eigen::Vector3d in_plane(const Stress& stress) {
  return {stress.xx, stress.yy, stress.xy};
}

double share_across(const BlockMaterial& material, Plane plane) {
  return plane == Plane::strain ? material.poissons_ratio : 0;
}

Stress with_across(const Eigen::Vector3d& in_plane, const Stress& start, double share_across) {
  return {in_plane[0], in_plane[1], in_plane[2],
          start.zz + share_across * (in_plane[0] + in_plane[1] - (start.xx + start.yy))};
}

Stress start_stress(const BlockMaterial& material, const Stress& gradient, double y, Plane plane) {
  const Stress& s = material.initial_stress;
  const Eigen::Vector3d start(s.xx + y * gradient.xx, s.yy + y * gradient.yy, s.xy + y * gradient.xy);
  Stress stress = with_across(start, {}, share_across(material, plane));
  if (plane == Plane::strain && material.gives_zz) stress.zz = s.zz + y * material.stress_gradient.zz;
  return stress;
}

}  // namespace keyblock
