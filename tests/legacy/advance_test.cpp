// Shi's step against theory: free fall, the oscillator's spectral radius, and the rebound from a contact spring.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "tests/support/standard_scenes.hpp"

namespace keyblock::advance_test {
namespace {

using support::legacy_scene;
using support::plain_analysis;
using support::rectangle;
using support::step_once;

// A free block of mass m on one fixed point at its centroid: an undamped oscillator with k = m (Omega/dt)².
struct Oscillator {
  ShiScene scene;
  Stepping stepping;

  Oscillator(double omega_dt, double carry_over) : scene(make(omega_dt, carry_over)), stepping(start(scene)) {}

  double next_x() {
    step_once(scene, stepping);
    return stepping.state.fixed_points[0].displacement.x;
  }

  static ShiScene make(double omega_dt, double carry_over) {
    constexpr double kDt = 1e-3;
    Blocks blocks;
    blocks.blocks = {rectangle({-0.5, -0.5}, {0.5, 0.5})};
    blocks.fixed_points = {{{0, 0}, 0, {}}};
    Analysis analysis = plain_analysis(kDt, 100);
    analysis.gravity = 0;
    analysis.velocity_carry_over = carry_over;
    analysis.block_materials[0].initial_velocity = {0.01, 0, 0};
    ShiScene scene = legacy_scene(blocks, analysis);
    // Ivelocity is stress gradient too in this profile; a centroid at y = 0 keeps that at zero.
    scene.settings.contact_penalty = 1;
    scene.settings.fixed_point_factor = 2500 * (omega_dt / kDt) * (omega_dt / kDt);
    return scene;
  }
};

}  // namespace

// dda-12: rho = 1/sqrt(1 + Omega²/2) for Omega <= 4 (own derivation from d = v dt + a dt²/2, a at the end of
// the step).
TEST(ShiStep, oscillator_decays_with_the_spectral_radius_of_theory) {
  for (double omega : {0.01, 0.1, 0.3, 1.0, 2.0, 4.0}) {
    Oscillator oscillator(omega, 1);
    std::array<double, 4> x{};
    for (double& value : x) value = oscillator.next_x();
    // x[n+2] = trace x[n+1] - det x[n], from two consecutive triples.
    const double determinant = (x[2] * x[2] - x[1] * x[3]) / (x[1] * x[1] - x[0] * x[2]);
    EXPECT_NEAR(std::sqrt(determinant), 1 / std::sqrt(1 + omega * omega / 2), 1e-6) << "Omega " << omega;
  }
}

// dda-12, static mode: the mode decays by 1/(1 + Omega²/2) a step.
TEST(ShiStep, static_mode_decays_by_one_over_one_plus_half_omega_squared) {
  for (double omega : {0.1, 0.3, 1.0, 2.0}) {
    Oscillator oscillator(omega, 0);
    oscillator.scene.model.fixed_points[0].curve = {{0, 1}, {{1e-3, 0}, {1e-3, 0}}, {}};  // to a displaced position
    const double first = 1e-3 - oscillator.next_x();
    const double second = 1e-3 - oscillator.next_x();
    EXPECT_NEAR(second / first, 1 / (1 + omega * omega / 2), 1e-6) << "Omega " << omega;
  }
}

// dda-01: s = g t²/2 and v = g t are exact for the constant-acceleration step, any dt.
TEST(ShiStep, free_fall_is_exact) {
  for (double dt : {1e-3, 1e-2}) {
    Blocks blocks;
    blocks.blocks = {rectangle({0, 10}, {1, 11})};
    const int steps = static_cast<int>(std::lround(1 / dt));
    const ShiScene scene = legacy_scene(blocks, plain_analysis(dt, steps));
    Stepping stepping = start(scene);
    for (int i = 0; i < steps; ++i) step_once(scene, stepping);
    const ElementState& block = stepping.state.elements[ElementIndex{0}];
    EXPECT_NEAR((block.centroid.y - 10.5) / -4.905, 1, 1e-10) << "dt " << dt;
    EXPECT_NEAR(end_velocity(block, stepping.state, scene.settings, 0)[1] / -9.81, 1, 1e-10) << "dt " << dt;
    EXPECT_NEAR(block.centroid.x, 0.5, 1e-12);
    EXPECT_NEAR(block.rotation, 0, 1e-15);
  }
}

namespace {

// Rebound speed over impact speed of a square falling flat, without weight, on a fixed floor: two contact springs.
// Stiff blocks and nearly rigid fixings leave only the contact springs to deform.
double rebound(double dt_over_contact_time, double gap_in_steps) {
  constexpr double kMass = 2500;
  constexpr double kPenalty = 1e6;
  constexpr double kSpeed = 0.1;
  const double contact_time = std::numbers::pi * std::sqrt(kMass / (2 * kPenalty));
  const double dt = dt_over_contact_time * contact_time;
  const double gap = gap_in_steps * kSpeed * dt;
  Blocks blocks;
  blocks.blocks = {rectangle({-2, -1}, {3, 0}), rectangle({0, gap}, {1, 1 + gap})};
  blocks.fixed_points = {{{-1.9, -0.9}, 0, {}}, {{2.9, -0.9}, 0, {}}, {{2.9, -0.1}, 0, {}}, {{-1.9, -0.1}, 0, {}}};
  Analysis analysis = plain_analysis(dt, 100000);
  analysis.gravity = 0;
  analysis.contact_penalty = kPenalty;
  analysis.block_materials[0].youngs_modulus = 1e10;
  analysis.open_close.closing_ratio = 0;
  analysis.allowed_displacement_ratio = 0.01;  // contacts are searched within 2.5 times this: less than the block
  ShiScene scene = legacy_scene(blocks, analysis);
  scene.settings.fixed_point_factor = 1e5;
  Stepping stepping = start(scene);
  stepping.state.elements[ElementIndex{1}].velocity[1] = -kSpeed;
  for (int i = 0; i < 20 + static_cast<int>(3 / dt_over_contact_time); ++i) step_once(scene, stepping);
  return end_velocity(stepping.state.elements[ElementIndex{1}], stepping.state, scene.settings, 0)[1] / kSpeed;
}

}  // namespace

// dda-11: restitution of Shi's step over dt/Tc, by direct stepping of the scalar recurrence (benchmark
// table), within 0.02.
TEST(ShiStep, rebound_from_a_contact_spring_loses_what_the_scalar_recurrence_loses) {
  constexpr std::array<std::pair<double, double>, 6> kTable{
      {{0.001, 0.997536}, {0.002, 0.995077}, {0.005, 0.98774}, {0.01, 0.975637}, {0.02, 0.951916}, {0.05, 0.884876}}};
  std::mt19937 random(1);
  std::uniform_real_distribution<double> gap(1, 2);  // random place of the impact within a step
  for (const auto& [ratio, expected] : kTable) {
    double sum = 0;
    for (int i = 0; i < 10; ++i) sum += rebound(ratio, gap(random));
    EXPECT_NEAR(sum / 10, expected, 0.02) << "dt/Tc " << ratio;
  }
}

// Without contacts the Newmark recurrence needs no more than one solve per step.
TEST(ShiStep, only_the_first_solve_of_a_run_is_repeated) {
  Blocks blocks;
  blocks.blocks = {rectangle({0, 10}, {1, 11})};
  const ShiScene scene = legacy_scene(blocks, plain_analysis(1e-3, 3));
  Stepping stepping = start(scene);
  EXPECT_EQ(step_once(scene, stepping).passes, 2);
  EXPECT_EQ(step_once(scene, stepping).passes, 1);
}

// s = g (sin α − tan φ cos α) t²/2, for two rigid blocks and for a rigid one on one that deforms. The contact sticks
// through the first step, so that the block is late by one: 2 dt / t of the way.
TEST(ShiStep, rigid_blocks_slide_as_theory_says_on_each_other_and_on_affine_ones) {
  const double slope = support::radians(30);
  const double dt = 1e-3;
  Analysis analysis = plain_analysis(dt, 500);
  analysis.allowed_displacement_ratio = 0.01;  // contacts are searched within 2.5 times this: less than the block
  analysis.joint_materials[0].friction_angle_deg = 20;
  analysis.block_materials.push_back(analysis.block_materials[0]);
  Blocks blocks = support::block_on_slope(slope);
  blocks.blocks[1].material = 1;
  Settings settings = profile_settings("legacy", analysis);
  const double acceleration = 9.81 * (std::sin(slope) - std::tan(support::radians(20)) * std::cos(slope));
  for (const bool floor_deforms : {false, true}) {
    settings.basis = BlockBasis::rigid;
    if (floor_deforms) settings.basis.own[0] = BlockBasis::affine;
    const ShiScene scene =
        shi_scene({with_moving_bases(model_from_blocks(blocks, analysis), settings.basis), settings});
    EXPECT_EQ(scene.model.elements[ElementIndex{0}].basis->unknown_count(), floor_deforms ? 6 : 3);
    EXPECT_EQ(scene.model.elements[ElementIndex{1}].basis->unknown_count(), 3);
    Stepping stepping = start(scene);
    const Point from = stepping.state.elements[ElementIndex{1}].centroid;
    for (int i = 0; i < 500; ++i) step_once(scene, stepping);
    const double way = distance(stepping.state.elements[ElementIndex{1}].centroid, from);
    const double expected = acceleration * 0.5 * 0.5 / 2;
    EXPECT_NEAR(way / expected, 1, 3 * dt / 0.5) << floor_deforms;
  }
}

// Iterations stop at 1e-11 of the load: their error is small beside the motion of a block.
TEST(Advance, every_way_to_solve_makes_the_same_steps) {
  std::vector<Point> places;
  for (const LinearMethod method : {LinearMethod::factor, LinearMethod::conjugate_gradients}) {
    Blocks blocks;
    blocks.blocks = {rectangle({-1, -1}, {2, 0}), rectangle({0, 0.001}, {1, 1})};
    blocks.fixed_points = {{{-0.5, -0.5}, 0, {}}, {{1.5, -0.5}, 0, {}}};
    ShiScene scene = legacy_scene(blocks, plain_analysis(1e-3, 30));
    scene.settings.linear_method = method;
    Stepping stepping = start(scene);
    for (int i = 0; i < 30; ++i) step_once(scene, stepping);
    places.push_back(stepping.state.elements[ElementIndex{1}].centroid);
  }
  EXPECT_GT(std::abs(places[0].y - 0.5005), 1e-3) << "it falls upon the lower one and is thrown back";
  EXPECT_LT(distance(places[1], places[0]), 1e-9);
}

}  // namespace keyblock::advance_test
