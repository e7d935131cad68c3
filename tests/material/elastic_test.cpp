// The moduli of the plane are Hooke's law of space with one stress or one strain left out.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/elastic.hpp"

#include <gtest/gtest.h>

namespace keyblock::material_elastic_test {
namespace {

constexpr double kE = 8e9;
constexpr double kNu = 0.3;

BlockMaterial rock() {
  BlockMaterial material;
  material.youngs_modulus = kE;
  material.poissons_ratio = kNu;
  return material;
}

/// Strains of Hooke's law in space under in-plane stresses and `szz`.
Eigen::Vector3d strain_of(const Eigen::Vector3d& s, double szz) {
  return Eigen::Vector3d(s[0] - kNu * (s[1] + szz), s[1] - kNu * (s[0] + szz), 2 * (1 + kNu) * s[2]) / kE;
}

const Eigen::Vector3d kStress(3e6, -7e6, 2e6);

}  // namespace

TEST(ElasticModulus, plane_stress_is_hookes_law_without_stress_across) {
  EXPECT_LT((plane_stress_modulus(rock()) * strain_of(kStress, 0) - kStress).norm(), 1e-14 * kStress.norm());
}

TEST(ElasticModulus, plane_strain_is_hookes_law_without_strain_across) {
  const double across = kNu * (kStress[0] + kStress[1]);  // ezz = (szz - nu (sxx + syy)) / E = 0
  EXPECT_LT((plane_strain_modulus(rock()) * strain_of(kStress, across) - kStress).norm(), 1e-14 * kStress.norm());
}

TEST(ElasticModulus, shear_is_the_same_in_both) {
  EXPECT_DOUBLE_EQ(plane_stress_modulus(rock())(2, 2), kE / 2.6);
  EXPECT_DOUBLE_EQ(plane_strain_modulus(rock())(2, 2), kE / 2.6);
}

}  // namespace keyblock::material_elastic_test
