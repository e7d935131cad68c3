// Logarithmic strain compared with eigenvalues and differences, the work of its steps with its energy, and both laws
// under uniaxial pressure with their closed forms.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/elastic_law.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>
#include <random>

#include "material/elastic.hpp"

namespace keyblock::elastic_law_test {
namespace {

BlockMaterial rock() {
  BlockMaterial material;
  material.youngs_modulus = 1000;
  material.poissons_ratio = 0.3;
  return material;
}

const Eigen::Matrix3d kModulus = plane_strain_modulus(rock());

Eigen::Matrix2d tensor(const Eigen::Vector3d& green) {
  Eigen::Matrix2d c;
  c << 1 + 2 * green(0), green(2), green(2), 1 + 2 * green(1);
  return c;
}

/// Function of symmetric C = Q diag Qᵀ.
Eigen::Vector3d log_by_eigenvalues(const Eigen::Vector3d& green) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> found(tensor(green));
  const Eigen::Matrix2d log = found.eigenvectors() * (found.eigenvalues().array().log() / 2).matrix().asDiagonal() *
                              found.eigenvectors().transpose();
  return {log(0, 0), log(1, 1), 2 * log(0, 1)};
}

/// Green strains of stretches between 0.3 and 2 along rotated axes.
class Strains {
 public:
  Eigen::Vector3d next(double least = 0.3, double most = 2) {
    std::uniform_real_distribution<double> stretch(least, most), angle(0, 3.2);
    const double a = std::pow(stretch(random_), 2), b = std::pow(stretch(random_), 2), turn = angle(random_);
    const double c = std::cos(turn), s = std::sin(turn);
    return {(c * c * a + s * s * b - 1) / 2, (s * s * a + c * c * b - 1) / 2, c * s * (a - b)};
  }

 private:
  std::mt19937 random_{7};
};

const Eigen::Vector3d kInitial(30, -50, 20);
const Eigen::Vector3d kNone(0, 0, 0);

ElasticPoint point_of(ElasticLaw law, const Eigen::Vector3d& initial = kInitial) {
  return {law, kModulus, Eigen::Map<const Eigen::Vector3d>(initial.data())};
}

Eigen::Matrix3d by_differences(const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& f,
                               const Eigen::Vector3d& at, double step) {
  Eigen::Matrix3d slope;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d way = step * Eigen::Vector3d::Unit(i);
    slope.col(i) = (f(at + way) - f(at - way)) / (2 * step);
  }
  return slope;
}

}  // namespace

TEST(ElasticLaw, the_logarithmic_strain_is_that_of_the_eigenvalues) {
  Strains strains;
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector3d green = strains.next();
    EXPECT_LT((log_strain(green) - log_by_eigenvalues(green)).norm(), 1e-14) << green.transpose();
  }
}

// ½ ln(1 + 2E) = E - E² + …: of strains of 1e-9 the first term is right to the last digits.
TEST(ElasticLaw, small_strains_keep_their_digits) {
  const Eigen::Vector3d green(3e-9, -2e-9, 1e-9);
  EXPECT_LT((log_strain(green) - green).norm(), 3e-17);
  EXPECT_LT((log_strain_rate(green) - Eigen::Matrix3d::Identity()).norm(), 2e-8);
  EXPECT_EQ(log_strain(Eigen::Vector3d::Zero()).norm(), 0);
}

TEST(ElasticLaw, rate_and_curvature_are_derivatives_where_stretches_differ_and_where_they_do_not) {
  Strains strains;
  const Eigen::Vector3d stress(3, -2, 5);
  for (int i = 0; i < 200; ++i) {
    Eigen::Vector3d green = strains.next(0.5);
    if (i % 4 == 0) green(1) = green(0) + 1e-6, green(2) = 1e-6;  // stretches as good as equal
    if (i % 4 == 1) green(1) = green(0), green(2) = 0;
    const double scale = log_strain_rate(green).norm();
    EXPECT_LT((by_differences(log_strain, green, 1e-5) - log_strain_rate(green)).norm(), 1e-7 * scale * scale);
    const auto pulled = [&](const Eigen::Vector3d& e) {
      return Eigen::Vector3d(log_strain_rate(e).transpose() * stress);
    };
    const Eigen::Matrix3d curvature = log_strain_curvature(green, stress);
    EXPECT_LT((by_differences(pulled, green, 1e-5) - curvature).norm(), 1e-5 * (1 + curvature.norm())) << i;
    EXPECT_LT((curvature - curvature.transpose()).norm(), 1e-12 * curvature.norm());
  }
}

TEST(ElasticLaw, stress_is_the_gradient_of_the_energy_and_stiffness_that_of_stress) {
  Strains strains;
  const ElasticPoint point = point_of(ElasticLaw::logarithmic);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d green = strains.next(0.5);
    Eigen::Vector3d slope;
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d way = 1e-5 * Eigen::Vector3d::Unit(k);
      slope(k) = (point.energy(green + way) - point.energy(green - way)) / 2e-5;
    }
    EXPECT_LT((slope - point.stress(green)).norm(), 1e-6 * (1000 + point.stress(green).norm()));
    const Eigen::Matrix3d stiffness = point.stiffness(green);
    const auto stress = [&](const Eigen::Vector3d& e) { return point.stress(e); };
    EXPECT_LT((by_differences(stress, green, 1e-5) - stiffness).norm(), 1e-6 * stiffness.norm());
  }
}

// In any step: the work of the force is the gain of energy for θ = ½, and T_θ · Δε else.
TEST(ElasticLaw, the_work_of_a_step_is_the_change_of_energy) {
  Strains strains;
  for (const ElasticLaw law : {ElasticLaw::st_venant_kirchhoff, ElasticLaw::logarithmic}) {
    const ElasticPoint point = point_of(law);
    for (int i = 0; i < 1000; ++i) {
      const Eigen::Vector3d from = strains.next();
      const Eigen::Vector3d to = i % 2 == 0 ? strains.next() : Eigen::Vector3d(from + 1e-4 * strains.next());
      const double change = point.energy(to) - point.energy(from);
      const double work = point.stress_of_step(from, to, 0.5).dot(to - from);
      EXPECT_NEAR(work, change, 1e-13 * (point.energy(from) + point.energy(to) + 1000));
      // Beyond the middle work is lost, never gained.
      EXPECT_GE(point.stress_of_step(from, to, 1).dot(to - from), change - 1e-12 * 1000);
    }
  }
}

TEST(ElasticLaw, the_stiffness_of_a_step_is_its_derivative_but_for_what_falls_with_the_step) {
  const ElasticPoint point = point_of(ElasticLaw::logarithmic);
  const Eigen::Vector3d from(0.2, -0.15, 0.1);
  double before = 1;
  for (const double size : {1e-2, 1e-3}) {
    const Eigen::Vector3d to = from + size * Eigen::Vector3d(1, -2, 0.5);
    const auto stress = [&](const Eigen::Vector3d& e) { return point.stress_of_step(from, e, 0.5); };
    const Eigen::Matrix3d exact = by_differences(stress, to, 1e-6);
    const double error = (exact - 0.5 * point.stiffness_of_step(from, to, 0.5)).norm() / exact.norm();
    EXPECT_LT(error, 4 * size);
    EXPECT_LT(error, before / 5);
    before = error;
  }
}

// The correction of the stress of a step vanishes with the square of the step, but its round-off is divided by that
// square.
TEST(ElasticLaw, steps_of_next_to_nothing_are_those_of_rest) {
  const Eigen::Vector3d from(-2e-4, -7e-4, 3e-4);
  const Eigen::Vector3d at_rest = log_step_stress(from, from, kInitial);
  const Eigen::Matrix3d stiffness = log_step_stiffness(from, from, kInitial, kModulus);
  for (double size = 1e-7; size > 1e-18; size /= 3) {
    const Eigen::Vector3d to = from + size * Eigen::Vector3d(1, -2, 0.5);
    EXPECT_LT((log_step_stress(from, to, kInitial) - at_rest).norm(), 1e-5 * kInitial.norm()) << size;
    EXPECT_LT((log_step_stiffness(from, to, kInitial, kModulus) - stiffness).norm(), 1e-5 * stiffness.norm()) << size;
  }
}

// A bar under plane strain with free sides, E* = E / (1 - ν²): F/A = E* λ (λ² - 1)/2, or E* ln λ / λ.
TEST(ElasticLaw, a_bar_under_pressure_softens_or_does_not) {
  const double plane = 1000 / (1 - 0.09);
  for (const double stretch : {1.2, 0.9, 0.7, 0.58, 0.4, 0.2, 0.1}) {
    for (const ElasticLaw law : {ElasticLaw::st_venant_kirchhoff, ElasticLaw::logarithmic}) {
      const ElasticPoint point = point_of(law, kNone);
      Eigen::Vector3d green((stretch * stretch - 1) / 2, 0, 0);
      for (int round = 0; round < 60; ++round)  // free sides
        green(1) -= point.stress(green)(1) / point.stiffness(green)(1, 1);
      const double force = stretch * point.stress(green)(0);
      const double theory = law == ElasticLaw::st_venant_kirchhoff ? plane * stretch * (stretch * stretch - 1) / 2
                                                                   : plane * std::log(stretch) / stretch;
      EXPECT_NEAR(force, theory, 1e-9 * std::abs(theory)) << stretch;
    }
  }
}

}  // namespace keyblock::elastic_law_test
