// Stress across the plane, compared with Hooke's law in three dimensions.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/material_stress.hpp"

#include <gtest/gtest.h>

namespace keyblock::material_stress_test {
namespace {

constexpr double kModulus = 3e9;
constexpr double kNu = 0.3;

BlockMaterial rock() {
  BlockMaterial material;
  material.youngs_modulus = kModulus;
  material.poissons_ratio = kNu;
  return material;
}

/// ezz of Hooke's law.
double strain_across(const Stress& s) {
  return (s.zz - kNu * (s.xx + s.yy)) / kModulus;
}

}  // namespace

TEST(MaterialStress, nothing_widens_across_the_plane_under_plane_strain) {
  const BlockMaterial material = rock();
  const Eigen::Vector3d strain(1e-3, -4e-4, 2e-4);
  const Stress stress =
      with_across(modulus_of(material, Plane::strain) * strain, {}, share_across(material, Plane::strain));
  EXPECT_NEAR(strain_across(stress), 0, 1e-18);
  EXPECT_NE(stress.zz, 0);
}

TEST(MaterialStress, there_is_none_across_the_plane_under_plane_stress) {
  BlockMaterial material = rock();
  material.initial_stress = {1e6, 2e6, 0, 5e6};
  material.gives_zz = true;
  EXPECT_EQ(start_stress(material, {}, 3, Plane::stress).zz, 0);
  EXPECT_EQ(with_across({1, 2, 3}, {}, share_across(material, Plane::stress)).zz, 0);
}

TEST(MaterialStress, the_start_has_what_is_given_or_else_what_the_law_says) {
  BlockMaterial material = rock();
  material.initial_stress = {-1e6, -2e6, 0};
  material.stress_gradient = {1e4, 2e4, 0};
  const Stress by_law = start_stress(material, material.stress_gradient, 10, Plane::strain);
  EXPECT_DOUBLE_EQ(by_law.zz, kNu * (-0.9e6 - 1.8e6));
  EXPECT_NEAR(strain_across(by_law), 0, 1e-18);
  material.gives_zz = true;
  material.initial_stress.zz = -3e6;
  material.stress_gradient.zz = 5e4;
  const Stress given = start_stress(material, material.stress_gradient, 10, Plane::strain);
  EXPECT_DOUBLE_EQ(given.zz, -2.5e6);
  // From there on the law decides the changes.
  EXPECT_DOUBLE_EQ(with_across({-0.9e6 + 1e5, -1.8e6, 0}, given, share_across(material, Plane::strain)).zz,
                   -2.5e6 + kNu * 1e5);
}

}  // namespace keyblock::material_stress_test
