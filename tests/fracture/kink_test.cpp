// Directions of growth by three criteria, against published tables and closed forms.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/kink.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace keyblock::kink_test {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;
constexpr PlaneElasticity kRock{1e5, 0.3, true};

struct Row {
  double mode_1, mode_2, angle, equivalent;
};

// Benchmark fra-14: θ = 2 atan((K_I - √(K_I² + 8 K_II²)) / 4 K_II).
TEST(Kink, hoop_stress_agrees_with_the_closed_form_of_erdogan_and_sih) {
  const std::array rows{Row{1, 0, 0, 1},
                        Row{1, 0.1, -11.2028776893, 1.0147465276},
                        Row{1, 0.25, -25.332938613, 1.08530066722},
                        Row{1, 0.5, -40.207818722, 1.28279457092},
                        Row{1, 1, -53.1301023542, 1.788854382},
                        Row{1, 2, -61.341844111, 2.90053715281},
                        Row{1, 5, -66.7595646435, 6.33690322854},
                        Row{0, 1, -70.5287793655, 1.15470053838}};
  for (const Row& row : rows) {
    for (const double sign : {1.0, -1.0}) {
      const Kink found = kink(GrowthCriterion::hoop_stress, kRock, {row.mode_1, sign * row.mode_2});
      EXPECT_NEAR(found.angle * kDegrees, sign * row.angle, 1e-9) << row.mode_2;
      EXPECT_NEAR(found.equivalent, row.equivalent, 1e-10) << row.mode_2;
    }
  }
}

// Independent figures of the recipes in the benchmarks' notes (ν 0.3, plane strain); pure sliding: arccos((1 - 2ν)/3).
TEST(Kink, least_strain_energy_agrees_with_the_table_of_sihs_criterion) {
  const std::array rows{Row{1, 0.1, -11.07, 0}, Row{1, 0.25, -24.16, 0}, Row{1, 0.5, -37.63, 0},
                        Row{1, 1, -51.91, 0},   Row{1, 2, -64.43, 0},    Row{1, 5, -74.63, 0}};
  for (const Row& row : rows)
    EXPECT_NEAR(kink(GrowthCriterion::strain_energy, kRock, {row.mode_1, row.mode_2}).angle * kDegrees, row.angle,
                0.006)
        << row.mode_2;
  EXPECT_NEAR(kink(GrowthCriterion::strain_energy, kRock, {0, 1}).angle, -std::acos((1 - 2 * 0.3) / 3), 1e-6);
  EXPECT_NEAR(kink(GrowthCriterion::strain_energy, kRock, {2, 0}).equivalent, 2, 1e-9);
}

TEST(Kink, greatest_energy_release_agrees_with_the_table_of_the_expansion) {
  const std::array rows{Row{1, 0.1, -11.25, 1.015}, Row{1, 0.25, -25.86, 1.086}, Row{1, 0.5, -42.03, 1.291},
                        Row{1, 1, -56.57, 1.826},   Row{1, 2, -65.78, 3.010},    Row{1, 5, -71.72, 6.675},
                        Row{0, 1, -75.76, 1.232}};
  for (const Row& row : rows) {
    const Kink found = kink(GrowthCriterion::energy_release, kRock, {row.mode_1, row.mode_2});
    EXPECT_NEAR(found.angle * kDegrees, row.angle, 0.01) << row.mode_2;
    EXPECT_NEAR(found.equivalent, row.equivalent, 6e-4) << row.mode_2;
  }
}

TEST(Kink, a_closed_tip_goes_by_its_sliding_alone) {
  const Kink pressed = kink(GrowthCriterion::hoop_stress, kRock, {-3, 1});
  EXPECT_NEAR(pressed.angle * kDegrees, -70.5287793655, 1e-9);
  EXPECT_NEAR(pressed.equivalent, 2 / std::sqrt(3.0), 1e-12);
  EXPECT_EQ(kink(GrowthCriterion::hoop_stress, kRock, {-1, 0}).equivalent, 0);
  EXPECT_EQ(kink(GrowthCriterion::energy_release, kRock, {0, 0}).equivalent, 0);
}

TEST(Kink, all_criteria_are_symmetric) {
  for (const GrowthCriterion criterion :
       {GrowthCriterion::hoop_stress, GrowthCriterion::strain_energy, GrowthCriterion::energy_release}) {
    const Kink left = kink(criterion, kRock, {1, -0.7}), right = kink(criterion, kRock, {1, 0.7});
    EXPECT_NEAR(left.angle, -right.angle, 1e-7);
    EXPECT_NEAR(left.equivalent, right.equivalent, 1e-9);
    EXPECT_GT(left.angle, 0);
  }
}

// Faces pressed together by K_I < 0 do not propagate if K_II is the difference of two good meshes; with more they
// slide.
TEST(Kink, a_tip_pressed_together_goes_nowhere_by_noise) {
  const Toughness toughness{.mode_1 = 1, .mode_2 = 2.0};
  for (const GrowthCriterion criterion :
       {GrowthCriterion::hoop_stress, GrowthCriterion::strain_energy, GrowthCriterion::energy_release}) {
    const Kink noise = kink(criterion, kRock, {-1, 0.02});
    EXPECT_EQ(noise.angle, 0);
    EXPECT_EQ(noise.equivalent, 0);
    EXPECT_EQ(equivalent_of(noise, toughness, {-1, 0.02}), 0);
    EXPECT_GT(kink(criterion, kRock, {-1, 0.5}).equivalent, 0);
    EXPECT_GT(kink(criterion, kRock, {0.01, 0.02}).equivalent, 0);
  }
  EXPECT_TRUE(faces_overlap({-1, 0.02}));
  EXPECT_TRUE(faces_overlap({-0.5, 0.5}));
  EXPECT_FALSE(faces_overlap({-0.02, 1}));
  EXPECT_FALSE(faces_overlap({0, 0}));
}

}  // namespace
}  // namespace keyblock::kink_test
