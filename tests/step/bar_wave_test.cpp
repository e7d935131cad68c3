// Benchmark dda-31: a pulse runs along a bar and returns from its end; the bar is made of sub-blocks and cut on covers.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/cover_scenes.hpp"

namespace keyblock::bar_wave_test {
namespace {

using support::mixed_scene_of;
using support::plain_analysis;
using support::rectangle;
using support::standard_settings;

// Row 2 of the benchmark: E 1e10 Pa, ν 0, ρ 2500 kg/m³; c = √(E/ρ).
constexpr double kModulus = 1e10;
constexpr double kDensity = 2500;
constexpr double kWaveSpeed = 2000;
constexpr double kPulse = 0.01;   // s
constexpr double kTopSpeed = 1;   // m/s
constexpr int kLength = 100;      // m
constexpr double kStep = 2.5e-4;  // s: half of the time per metre

// The displacement of the left end: the integral of half a sine of velocity.
TimeCurve pulse() {
  TimeCurve curve;
  for (int i = 0; i <= 40; ++i) {
    const double t = i * kPulse / 40;
    curve.times.push_back(t);
    curve.values.push_back({kTopSpeed * kPulse / std::numbers::pi * (1 - std::cos(std::numbers::pi * t / kPulse)), 0});
  }
  return curve;
}

Analysis bar_analysis() {
  Analysis analysis = plain_analysis(kStep, 1);
  BlockMaterial& rock = analysis.block_materials[0];
  rock.density = kDensity;
  rock.unit_weight = 0;
  rock.youngs_modulus = kModulus;
  rock.poissons_ratio = 0;
  analysis.gravity = 0;
  analysis.penalty_factor = 100;
  analysis.joint_materials[0].cohesion = analysis.joint_materials[0].tensile_strength = 1e12;
  return analysis;
}

Settings bar_settings(const Analysis& analysis) {
  Settings settings = standard_settings(analysis);
  settings.standard.strain_damping = StrainDamping::none;
  settings.standard.force_weight = 0.5;  // average acceleration: no loss of the integrator
  settings.standard.enforcement = Enforcement::penalty;
  return settings;
}

enum class Bar { of_blocks, on_covers };

// Both ends may be fixed; the left one is driven.
Scene bar(Bar kind, bool holds_right_end) {
  const Analysis analysis = bar_analysis();
  const Settings settings = bar_settings(analysis);
  Blocks blocks;
  if (kind == Bar::of_blocks)
    for (int i = 0; i < kLength; ++i) blocks.blocks.push_back(rectangle({1.0 * i, 0}, {i + 1.0, 1}));
  else
    blocks.blocks.push_back(rectangle({0, 0}, {kLength, 1}));
  Scene scene = kind == Bar::of_blocks ? support::standard_scene_of(blocks, analysis, settings)
                                       : mixed_scene_of(blocks, {0}, analysis, settings, 25, CoverFunctions::derived);
  // The corners of the left face, and of the right one.
  for (VertexIndex v : indices(scene.model.vertices)) {
    const Point place = scene.model.start_vertices[static_cast<std::size_t>(v.value)];
    const bool is_corner = place.y == 0 || place.y == 1;
    if (is_corner && place.x == 0)
      scene.model.fixed_points.push_back({place, scene.model.vertices[v].element, pulse()});
    if (is_corner && place.x == kLength && holds_right_end)
      scene.model.fixed_points.push_back({place, scene.model.vertices[v].element, {}});
  }
  return scene;
}

// The mean displacement along the bar and the mean stress of the blocks or elements about x, step by step.
struct Record {
  std::vector<double> times;
  std::vector<double> ways;
  std::vector<double> stresses;

  double top_speed() const {
    double top = 0;
    for (std::size_t i = 1; i < ways.size(); ++i) top = std::max(top, (ways[i] - ways[i - 1]) / kStep);
    return top;
  }
  // When half of `whole` is reached.
  double time_at_half(double whole) const {
    for (std::size_t i = 1; i < ways.size(); ++i)
      if (ways[i] >= whole / 2) return times[i - 1] + kStep * (whole / 2 - ways[i - 1]) / (ways[i] - ways[i - 1]);
    return 0;
  }
};

Record watch(const Scene& scene, double from, double to, double until) {
  StandardStepper stepper(scene);
  const State start = stepper.state();
  std::vector<ElementIndex> about;
  for (ElementIndex e : indices(start.elements))
    if (from <= start.elements[e].centroid.x && start.elements[e].centroid.x <= to) about.push_back(e);
  Record record;
  while (stepper.state().time < until) {
    support::run_to(stepper, stepper.state().time + kStep);
    double area = 0;
    double way = 0;
    double stress = 0;
    for (ElementIndex e : about) {
      const ElementState& now = stepper.state().elements[e];
      const double share = start.elements[e].moments.area;
      area += share;
      way += share * (now.centroid.x - start.elements[e].centroid.x);
      stress += share * now.stress.xx;
    }
    record.times.push_back(stepper.state().time);
    record.ways.push_back(way / area);
    record.stresses.push_back(stress / area);
  }
  return record;
}

const double kWay = 2 * kTopSpeed * kPulse / std::numbers::pi;

class BarWave : public ::testing::TestWithParam<Bar> {};

// Arrival within 2 %, loss of amplitude below 5 % (the benchmark's limits); the end of a free bar moves twice as fast.
TEST_P(BarWave, arrives_in_time_and_doubles_the_speed_of_a_free_end) {
  const Scene scene = bar(GetParam(), false);
  const Record middle = watch(scene, 49.5, 50.6, 0.045);
  EXPECT_NEAR((middle.time_at_half(kWay) - kPulse / 2) / (50.05 / kWaveSpeed), 1, 0.02);
  EXPECT_NEAR(middle.top_speed() / kTopSpeed, 1, 0.05);
  EXPECT_NEAR(*std::ranges::min_element(middle.stresses) / (-kDensity * kWaveSpeed * kTopSpeed), 1, 0.05);
  const Record end = watch(scene, 99, 100, 0.065);
  EXPECT_NEAR((end.time_at_half(2 * kWay) - kPulse / 2) / (kLength / kWaveSpeed), 1, 0.02);
  EXPECT_NEAR(end.top_speed() / (2 * kTopSpeed), 1, 0.05);
}

// Back at the middle: a free end sends tension back, a fixed one compression, and at the fixed end the stress is
// doubled.
TEST_P(BarWave, turns_back_at_its_end) {
  const double peak = kDensity * kWaveSpeed * kTopSpeed;
  const Record free = watch(bar(GetParam(), false), 49.5, 50.6, 0.09);

  EXPECT_NEAR(*std::ranges::max_element(free.stresses) / peak, 1, 0.05);
  EXPECT_NEAR(free.ways.back() / (2 * kWay), 1, 0.02);
  const Scene held = bar(GetParam(), true);
  const Record end = watch(held, 98.9, 100, 0.07);
  EXPECT_NEAR(*std::ranges::min_element(end.stresses) / (-2 * peak), 1, 0.05);
  EXPECT_NEAR(watch(held, 49.5, 50.6, 0.09).ways.back() / kWay, 0, 0.02);
}

INSTANTIATE_TEST_SUITE_P(Bars, BarWave, ::testing::Values(Bar::of_blocks, Bar::on_covers),
                         [](const auto& bar) { return bar.param == Bar::of_blocks ? "of_blocks" : "on_covers"; });

}  // namespace
}  // namespace keyblock::bar_wave_test
