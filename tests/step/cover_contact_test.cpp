// Contact of bodies on covers with blocks and with each other in profile `standard`, against theory.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>

#include "tests/support/cover_scenes.hpp"
#include "tests/support/ledger_runs.hpp"

namespace keyblock::cover_contact_test {
namespace {

using support::block_on_slope;
using support::ledger_of;
using support::mixed_scene_of;
using support::plain_analysis;
using support::radians;
using support::rectangle;
using support::run_to;
using support::standard_settings;

constexpr double kGravity = 9.81;
constexpr double kDensity = 2500;
constexpr double kModulus = 5e9;

constexpr std::array kEnforcements{Enforcement::penalty, Enforcement::lagrange};

std::string name_of_enforcement(Enforcement enforcement) {
  return enforcement == Enforcement::penalty ? "springs" : "multipliers";
}

// Weighted by area, of the elements on covers.
Point mean_place(const StandardStepper& stepper) {
  const State& state = stepper.state();
  Point sum;
  double area = 0;
  for (ElementIndex e : indices(state.elements)) {
    if (!stepper.scene().model.elements[e].is_on_covers()) continue;
    area += state.elements[e].moments.area;
    sum = sum + state.elements[e].moments.area * state.elements[e].centroid;
  }
  return (1 / area) * sum;
}

Settings settings_for(const Analysis& analysis, Enforcement enforcement) {
  Settings settings = standard_settings(analysis);
  settings.standard.enforcement = enforcement;
  return settings;
}

Scene slope(CoverFunctions functions, int half_rows, Enforcement enforcement) {
  Analysis analysis = plain_analysis(1e-3, 1);
  analysis.penalty_factor = 10;
  analysis.joint_materials[0].friction_angle_deg = 20;
  return mixed_scene_of(block_on_slope(radians(30)), {1}, analysis, settings_for(analysis, enforcement), half_rows,
                        functions);
}

// Benchmark dda-03: g/2 (sin α − cos α tan φ) t², no turning and no rise off the slope. The limit is that of the block.
TEST(CoverContact, a_block_on_covers_slides_as_coulomb_says) {
  constexpr std::array<std::pair<CoverFunctions, int>, 3> kMeshes{
      {{CoverFunctions::constant, 2}, {CoverFunctions::derived, 1}, {CoverFunctions::linear, 1}}};
  for (const Enforcement enforcement : kEnforcements)
    for (const auto& [functions, half_rows] : kMeshes) {
      const Scene scene = slope(functions, half_rows, enforcement);
      StandardStepper stepper(scene);
      const Point start = mean_place(stepper);
      run_to(stepper, 0.1);
      const Point way = mean_place(stepper) - start;
      const double a = radians(30);
      const double theory = kGravity / 2 * (std::sin(a) - std::cos(a) * std::tan(radians(20))) * 0.1 * 0.1;
      const std::string what = fmt::format("{} {}", name_of(functions), name_of_enforcement(enforcement));
      EXPECT_NEAR(dot(way, {std::cos(a), -std::sin(a)}) / theory, 1, 1e-3) << what;
      EXPECT_NEAR(dot(way, {std::sin(a), std::cos(a)}), 0, 1e-3 * theory) << what;
    }
}

// A floor and `count` squares of a metre on it, all on covers, without friction and without Poisson's effect.
Scene column(int count, Enforcement enforcement, CoverFunctions functions) {
  Analysis analysis = plain_analysis(1e-3, 1);
  analysis.block_materials[0].poissons_ratio = 0;
  analysis.penalty_factor = 1e4;
  Blocks blocks;
  blocks.blocks.push_back(rectangle({-5, -2}, {5, 0}));
  blocks.fixed_points = {{{-4, -1}, 0, {}}, {{4, -1}, 0, {}}};
  std::vector<int> meshed;
  for (int i = 0; i < count; ++i) {
    // Out of line, so that the nodes of the two meshes do not meet.
    const double shift = i % 2 == 0 ? 0 : 0.013;
    blocks.blocks.push_back(rectangle({-0.5 + shift, 1.0 * i}, {0.5 + shift, i + 1.0}));
    meshed.push_back(i + 1);
  }
  Settings settings = settings_for(analysis, enforcement);
  settings.standard.motion = MotionRule::equilibrium;
  return mixed_scene_of(blocks, meshed, analysis, settings, 2, functions);
}

// Uniaxial: the top of a column of height H settles by ρ g H²/(2 E), which quadratic functions hold exactly.
TEST(CoverContact, a_column_settles_under_its_weight) {
  for (const Enforcement enforcement : kEnforcements) {
    const Scene scene = column(1, enforcement, CoverFunctions::derived);
    StandardStepper stepper(scene);
    run_to(stepper, 1e-3);
    const double theory = -kDensity * kGravity / (2 * kModulus);
    int at_top = 0;
    for (VertexIndex v : indices(scene.model.vertices)) {
      const Point start = scene.model.start_vertices[static_cast<std::size_t>(v.value)];
      if (start.y != 1) continue;
      ++at_top;
      EXPECT_NEAR((stepper.state().vertices[v].y - 1) / theory, 1, 3e-3) << name_of_enforcement(enforcement);
    }
    EXPECT_GE(at_top, 2);
  }
}

TEST(CoverContact, faces_of_two_meshes_carry_the_weight_of_what_is_above) {
  for (const Enforcement enforcement : kEnforcements) {
    const Scene scene = column(2, enforcement, CoverFunctions::derived);
    StandardStepper stepper(scene);
    run_to(stepper, 1e-3);
    const double theory = -kDensity * kGravity * 4 / (2 * kModulus);
    double sum = 0;
    int count = 0;
    for (VertexIndex v : indices(scene.model.vertices)) {
      if (scene.model.start_vertices[static_cast<std::size_t>(v.value)].y != 2) continue;
      sum += stepper.state().vertices[v].y - 2;
      ++count;
    }
    // The faces are 13 mm out of line: stress gathers where each ends.
    EXPECT_NEAR(sum / count / theory, 1, 5e-3) << name_of_enforcement(enforcement);
  }
}

// Two squares meet at 1 m/s each: the law of restitution holds for their mass centres, momentum is kept, the books close.
TEST(CoverContact, bodies_on_covers_bounce_by_the_law_of_restitution) {
  Analysis analysis = plain_analysis(1e-3, 1);
  analysis.block_materials[0].unit_weight = 0;
  analysis.gravity = 0;
  analysis.block_materials.push_back(analysis.block_materials[0]);
  analysis.block_materials[0].initial_velocity = {1, 0, 0};
  analysis.block_materials[1].initial_velocity = {-1, 0, 0};
  Blocks blocks;
  blocks.blocks = {rectangle({0, 0}, {1, 1}), rectangle({1.0105, 0}, {2.0105, 1})};
  blocks.blocks[1].material = 1;
  for (const double restitution : {0.0, 0.5}) {
    Settings settings = settings_for(analysis, Enforcement::lagrange);
    settings.standard.restitution = restitution;
    const Scene scene = mixed_scene_of(blocks, {0, 1}, analysis, settings, 2, CoverFunctions::derived);
    const Ledger ledger = ledger_of(scene, 0.03);
    const double mass = kDensity;
    EXPECT_NEAR(ledger.rows.front().stored.kinetic, mass, 1e-9 * mass);
    EXPECT_NEAR(ledger.rows.back().stored.kinetic / mass, restitution * restitution, 1e-6);
    EXPECT_NEAR(ledger.rows.back().flow.impact / mass, 1 - restitution * restitution, 1e-6);
    EXPECT_LE(sums_of(ledger).energy_closure(), 1e-9);
    EXPECT_LE(sums_of(ledger).linear_momentum_closure(), 1e-12);
  }
}

// A square falls on a soft slab whose foot is held by the problem itself: the slab is struck, not shot off its support, and every
// energy is booked.
TEST(CoverContact, a_body_held_by_its_supports_is_a_wall_to_impacts) {
  Analysis analysis = plain_analysis(2e-3, 1);
  analysis.block_materials.push_back(analysis.block_materials[0]);
  analysis.block_materials[0].youngs_modulus = 1e7;
  Blocks blocks;
  blocks.blocks = {rectangle({-3, -1}, {3, 0}), rectangle({-0.5, 0.05}, {0.5, 1.05})};
  blocks.blocks[1].material = 1;
  Scene scene =
      mixed_scene_of(blocks, {0}, analysis, settings_for(analysis, Enforcement::penalty), 2, CoverFunctions::derived);
  Continuum held = *scene.model.continuum;
  held.prescribed.push_back({{{-3, -1}, {3, -1}}, Held::both, {}});
  held.prescribed.back().value = [](Point, Point) { return Point{}; };
  scene.model.continuum = std::make_shared<Continuum>(std::move(held));
  const Ledger ledger = ledger_of(scene, 0.2);
  EXPECT_LE(sums_of(ledger).energy_closure(), 1e-9);
  const double fallen = kDensity * kGravity * 0.05;
  double impact = 0;
  for (const LedgerRow& row : ledger.rows) {
    EXPECT_GE(row.flow.impact, impact - 1e-9 * fallen) << row.time;
    impact = row.flow.impact;
  }
  EXPECT_NEAR(impact / fallen, 1, 0.1) << "without restitution the fall is lost";
  EXPECT_TRUE(ledger.scope.has_supports);
}

}  // namespace
}  // namespace keyblock::cover_contact_test
