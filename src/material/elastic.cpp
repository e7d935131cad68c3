// Computes the two elastic moduli of the plane.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/elastic.hpp"

namespace keyblock {

Eigen::Matrix3d plane_stress_modulus(const BlockMaterial& material) {
  const double nu = material.poissons_ratio;
  Eigen::Matrix3d d;
  d << 1, nu, 0, nu, 1, 0, 0, 0, (1 - nu) / 2;
  return material.youngs_modulus / (1 - nu * nu) * d;
}

Eigen::Matrix3d plane_strain_modulus(const BlockMaterial& material) {
  const double nu = material.poissons_ratio;
  const double direct = (1 - nu) / (1 - 2 * nu);
  const double cross = nu / (1 - 2 * nu);
  Eigen::Matrix3d d;
  d << direct, cross, 0, cross, direct, 0, 0, 0, 0.5;
  return material.youngs_modulus / (1 + nu) * d;
}

}  // namespace keyblock
