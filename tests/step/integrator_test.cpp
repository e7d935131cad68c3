// Spectral radii of the integrators on one spring and mass, compared with closed forms (benchmark dda-12) and a matrix.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/bodies/integrator.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "step/bodies/step_equations.hpp"

namespace keyblock::integrator_test {
namespace {

constexpr double kStep = 0.01;

StandardChoices weighted(double velocity_weight, double force_weight) {
  StandardChoices choices;
  choices.velocity_weight = velocity_weight;
  choices.force_weight = force_weight;
  choices.strain_damping = StrainDamping::none;
  return choices;
}

StandardChoices newmark(double beta, double gamma) {
  StandardChoices choices;
  choices.integrator = Integrator::newmark;
  choices.newmark_beta = beta;
  choices.newmark_gamma = gamma;
  return choices;
}

StandardChoices generalized_alpha(double rho) {
  StandardChoices choices;
  choices.integrator = Integrator::generalized_alpha;
  choices.rho_infinity = rho;
  return choices;
}

Unknowns one(double x) {
  return Unknowns::Constant(1, x);
}

// Mass 1 and stiffness ω² with ω dt = Ω.
Body oscillator(double omega_dt) {
  Body body;
  body.mass = UnknownBlock::Identity(1, 1);
  body.stiffness = UnknownBlock::Constant(1, 1, omega_dt * omega_dt / (kStep * kStep));
  body.initial_stress = one(0);
  return body;
}

// Effect of a step on (q, dt v, dt² a), column by column.
Eigen::Matrix3d amplification(const StandardChoices& choices, double omega_dt) {
  const StepRule rule = step_rule(choices, kStep);
  const Body body = oscillator(omega_dt);
  Eigen::Matrix3d matrix;
  for (int i = 0; i < 3; ++i) {
    const Unknowns q = one(i == 0 ? 1 : 0);
    const Unknowns v = one(i == 1 ? 1 / kStep : 0);
    const Unknowns a = one(i == 2 ? 1 / (kStep * kStep) : 0);
    KeptInverse kept;
    const StepEquations step = step_equations(body, {q, v, a}, one(0), rule, kept);
    const double by = step.free[0];
    matrix.col(i) << q[0] + by, kStep * (step.known_velocity[0] + rule.end_velocity.increment * by),
        kStep * kStep * (step.known_acceleration[0] + rule.end_acceleration.increment * by);
  }
  return matrix;
}

double spectral_radius(const StandardChoices& choices, double omega_dt) {
  return amplification(choices, omega_dt).eigenvalues().cwiseAbs().maxCoeff();
}

// Generalised α from its four equations in (q1, dt v1, dt² a1), solved as they stand in Chung & Hulbert 1993.
double spectral_radius_of_the_paper(double rho, double omega_dt) {
  const double am = (2 * rho - 1) / (rho + 1);
  const double af = rho / (rho + 1);
  const double gamma = 0.5 - am + af;
  const double beta = (1 - am + af) * (1 - am + af) / 4;
  const double w = omega_dt * omega_dt;
  Eigen::Matrix3d end, start;
  end << 1, 0, -beta, 0, 1, -gamma, (1 - af) * w, 0, 1 - am;
  start << 1, 1, 0.5 - beta, 0, 1, 1 - gamma, -af * w, 0, -am;
  return (end.inverse() * start).eigenvalues().cwiseAbs().maxCoeff();
}

}  // namespace

// dda-12: ρ = 1/√(1 + Ω²/2) for Ω ≤ 4, verified there by eigenvalues.
TEST(Integrator, shi_damps_an_oscillator_by_the_closed_form) {
  for (double w : {0.01, 0.1, 0.3, 1.0, 2.0, 4.0}) {
    const double expected = 1 / std::sqrt(1 + w * w / 2);
    EXPECT_NEAR(spectral_radius(weighted(0.5, 1), w), expected, 1e-7) << w;
    EXPECT_NEAR(spectral_radius(newmark(0.5, 1), w), expected, 1e-7) << w;
  }
}

// (1 + Ω²) u1 = u0 − Ω² q0, q1 = q0 + (u0 + u1)/2 with u = dt v. The determinant is (1 + Ω²/2)/(1 + Ω²), the trace
// (1 + ½)/(1 + Ω²) + ½. The roots are a conjugate pair in the range of the test.
TEST(Integrator, strains_that_follow_the_rate_are_damped_by_the_closed_form_and_never_turned_over_for_ever) {
  StandardChoices choices = weighted(0.5, 0.5);
  choices.strain_damping = StrainDamping::critical;
  for (double w : {0.1, 1.0, 2.0, 10.0, 1000.0})
    EXPECT_NEAR(spectral_radius(choices, w), std::sqrt((1 + w * w / 2) / (1 + w * w)), 1e-7) << w;
}

TEST(Integrator, average_acceleration_damps_nothing) {
  for (double w : {0.01, 0.1, 1.0, 10.0, 1000.0}) {
    EXPECT_NEAR(spectral_radius(weighted(0.5, 0.5), w), 1, 1e-9) << w;
    EXPECT_NEAR(spectral_radius(newmark(0.25, 0.5), w), 1, 1e-9) << w;
    EXPECT_NEAR(spectral_radius(generalized_alpha(1), w), 1, 1e-7) << w;
  }
}

// The product of Newmark's two conjugate roots is 1 − (γ−½) Ω²/(1 + β Ω²).
TEST(Integrator, newmark_damps_by_the_product_of_its_roots) {
  for (double w : {0.1, 1.0, 2.0})
    EXPECT_NEAR(spectral_radius(newmark(0.36, 0.7), w), std::sqrt(1 - 0.2 * w * w / (1 + 0.36 * w * w)), 1e-9) << w;
}

// At the limit all three roots meet at −ρ∞. There an eigenvalue is known to the cube root of round-off only; the sum
// and the product of the roots are known in full.
TEST(Integrator, generalised_alpha_leaves_rho_infinity_of_high_frequencies) {
  for (double rho : {0.0, 0.3, 0.5, 0.8, 1.0}) {
    const Eigen::Matrix3d limit = amplification(generalized_alpha(rho), 1e5);
    EXPECT_NEAR(limit.trace(), -3 * rho, 1e-6) << rho;
    EXPECT_NEAR(limit.determinant(), -rho * rho * rho, 1e-6) << rho;
    EXPECT_NEAR(spectral_radius(generalized_alpha(rho), 1e5), rho, 2e-3) << rho;
  }
}

TEST(Integrator, generalised_alpha_damps_as_the_equations_of_its_paper) {
  for (double rho : {0.0, 0.3, 0.5, 0.8, 1.0}) {
    for (double w : {0.01, 0.1, 1.0, 3.0, 30.0}) {
      EXPECT_NEAR(spectral_radius(generalized_alpha(rho), w), spectral_radius_of_the_paper(rho, w), 1e-7);
      EXPECT_LE(spectral_radius(generalized_alpha(rho), w), 1 + 1e-9);
    }
  }
}

// Shi's step is Newmark's with β = 1/2 and γ = 1: the same sums up to round-off.
TEST(Integrator, shi_is_a_newmark_step) {
  for (double w : {0.01, 1.0, 100.0})
    EXPECT_LE((amplification(weighted(0.5, 1), w) - amplification(newmark(0.5, 1), w)).norm(), 1e-13 * w * w + 1e-14);
}

}  // namespace keyblock::integrator_test
