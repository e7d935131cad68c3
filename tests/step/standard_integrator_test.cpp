// The integrators in whole runs: order of convergence, free fall, and a sliding block whose motion they must not
// change.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>

#include "tests/support/standard_scenes.hpp"

namespace keyblock::standard_integrator_test {
namespace {

using support::block_on_slope;
using support::plain_analysis;
using support::radians;
using support::rectangle;
using support::run_to;
using support::standard_scene_of;
using support::standard_settings;

struct Method {
  const char* name;
  Integrator integrator;
  double force_weight = 1;
  double rho = 0.8;
};

constexpr std::array<Method, 5> kMethods{{{"weighted, Shi", Integrator::weighted, 1},
                                          {"weighted, average", Integrator::weighted, 0.5},
                                          {"newmark, average", Integrator::newmark},
                                          {"generalised alpha 0.8", Integrator::generalized_alpha, 1, 0.8},
                                          {"generalised alpha 0", Integrator::generalized_alpha, 1, 0}}};

Settings settings_of(const Analysis& analysis, const Method& method) {
  Settings settings = standard_settings(analysis);
  settings.standard.integrator = method.integrator;
  settings.standard.force_weight = method.force_weight;
  settings.standard.rho_infinity = method.rho;
  return settings;
}

constexpr double kModulus = 5e9;
constexpr double kDensity = 2500;
constexpr double kStress = 1e6;

// A free unit square under a stress of its own, ν = 0, released: ρ/12 ε̈ + E ε = −σ.
double strain_error(const Method& method, int steps) {
  const double omega = std::sqrt(12 * kModulus / kDensity);
  const double end = 2.1 / omega;
  Analysis analysis = plain_analysis(end / steps, 1);
  analysis.gravity = 0;
  analysis.block_materials[0].density = kDensity;
  analysis.block_materials[0].youngs_modulus = kModulus;
  analysis.block_materials[0].poissons_ratio = 0;
  analysis.block_materials[0].initial_stress = {kStress, 0, 0};
  Settings settings = settings_of(analysis, method);
  settings.standard.strain_damping = StrainDamping::none;
  const Scene scene = standard_scene_of({{rectangle({0, 0}, {1, 1})}, {}, {}, {}, {}, {}}, analysis, settings);
  StandardStepper stepper(scene);
  for (int i = 0; i < steps; ++i) EXPECT_TRUE(std::holds_alternative<StepReport>(stepper.advance()));
  const double expected = -kStress / kModulus * (1 - std::cos(omega * end));
  return std::abs(stepper.motion().q[ElementIndex{0}][3] / expected - 1);
}

}  // namespace

TEST(StandardIntegrator, error_falls_by_four_with_half_the_step_and_by_two_under_shi) {
  for (const Method& method : kMethods) {
    const double ratio = strain_error(method, 400) / strain_error(method, 800);
    const double expected = std::string(method.name) == "weighted, Shi" ? 2 : 4;
    EXPECT_NEAR(ratio / expected, 1, 0.03) << method.name;
    RecordProperty(method.name, fmt::format("{:.3f}", ratio));
  }
}

// dda-01: g t²/2 and g t.
TEST(StandardIntegrator, free_fall_is_exact_under_each) {
  for (const Method& method : kMethods) {
    for (double dt : {1e-3, 0.1}) {
      const Analysis analysis = plain_analysis(dt, 1);
      const Scene scene = standard_scene_of({{rectangle({0, 10}, {1, 11})}, {}, {}, {}, {}, {}}, analysis,
                                            settings_of(analysis, method));
      StandardStepper stepper(scene);
      run_to(stepper, 1);
      const ElementState& block = stepper.state().elements[ElementIndex{0}];
      EXPECT_NEAR((block.centroid.y - 10.5) / -4.905, 1, 1e-10) << method.name << ", dt " << dt;
      EXPECT_NEAR(block.velocity[1] / -9.81, 1, 1e-10) << method.name << ", dt " << dt;
    }
  }
}

// dda-03: s = g/2 (sin a − cos a tan φ) t².
TEST(StandardIntegrator, a_sliding_block_follows_the_closed_form_under_each) {
  for (const Method& method : kMethods) {
    for (BlockBasis basis : {BlockBasis::rigid, BlockBasis::affine}) {
      double worst = 0;
      for (const auto& [slope, friction] : std::array<std::pair<double, double>, 3>{{{15, 5}, {30, 15}, {45, 40}}}) {
        const double a = radians(slope);
        Analysis analysis = plain_analysis(1e-2, 1);
        analysis.joint_materials[0].friction_angle_deg = friction;
        Settings settings = settings_of(analysis, method);
        settings.basis = basis;
        const Scene scene = standard_scene_of(block_on_slope(a), analysis, settings);
        StandardStepper stepper(scene);
        const State start = stepper.state();
        run_to(stepper, 1);
        const double slip = dot(support::travel(stepper, start, 1), {std::cos(a), -std::sin(a)});
        const double expected = 9.81 / 2 * (std::sin(a) - std::cos(a) * std::tan(radians(friction)));
        EXPECT_NEAR(slip, expected, 1e-10) << method.name << ", slope " << slope << ", friction " << friction;
        worst = std::max(worst, std::abs(slip - expected));
      }
      RecordProperty(fmt::format("{}, basis {}", method.name, static_cast<int>(basis)), fmt::format("{:.1e}", worst));
    }
  }
}

// dda-05: it stops after v0²/(2 a) and stays at rest, for any acceleration that it carried while it slid.
TEST(StandardIntegrator, a_block_that_stops_stays_under_each) {
  for (const Method& method : kMethods) {
    Analysis analysis = plain_analysis(1e-2, 1);
    const double a = radians(15);
    analysis.joint_materials[0].friction_angle_deg = 30;
    analysis.block_materials[0].initial_velocity = {3 * std::cos(a), -3 * std::sin(a), 0};
    const Scene scene = standard_scene_of(block_on_slope(a), analysis, settings_of(analysis, method));
    StandardStepper stepper(scene);
    const State start = stepper.state();
    const double deceleration = 9.81 * (std::cos(a) * std::tan(radians(30)) - std::sin(a));
    run_to(stepper, 3 / deceleration + 0.2);
    const double slip = dot(support::travel(stepper, start, 1), {std::cos(a), -std::sin(a)});
    EXPECT_NEAR(slip, 9 / (2 * deceleration), deceleration * 1e-4) << method.name;
    const Unknowns& v = stepper.state().elements[ElementIndex{1}].velocity;
    EXPECT_LE(v.head<2>().norm(), 1e-3) << method.name;
  }
}

}  // namespace keyblock::standard_integrator_test
