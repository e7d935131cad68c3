// Contact of NMM bodies with blocks and with each other in profile `standard`, compared with theory.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>

#include "tests/support/cover_scenes.hpp"
#include "tests/support/ledger_runs.hpp"
#include "tests/support/ledger_sums.hpp"

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
constexpr double kBar = 8;
constexpr double kThickness = 0.5;
constexpr double kSpeed = 0.5;
constexpr double kWaveSpeed = 2000;

constexpr std::array kEnforcements{Enforcement::penalty, Enforcement::lagrange};

std::string name_of_enforcement(Enforcement enforcement) {
  return enforcement == Enforcement::penalty ? "springs" : "multipliers";
}

// Mean weighted by area, of the elements on covers.
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

// Benchmark dda-03: g/2 (sin α − cos α tan φ) t², no rotation and no rise off the slope. The limit is that of the
// block.
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

// Two bars without Poisson's effect that meet at half a metre per second each.
Scene colliding_bars(int half_rows, double restitution, double dt) {
  Analysis analysis = plain_analysis(dt, 1);
  BlockMaterial& rock = analysis.block_materials[0];
  rock.unit_weight = 0;
  rock.poissons_ratio = 0;
  rock.youngs_modulus = kDensity * kWaveSpeed * kWaveSpeed;
  analysis.gravity = 0;
  analysis.block_materials.push_back(rock);
  analysis.block_materials[0].initial_velocity = {kSpeed, 0, 0};
  analysis.block_materials[1].initial_velocity = {-kSpeed, 0, 0};
  Blocks blocks;
  blocks.blocks = {rectangle({0, 0}, {kBar, kThickness}), rectangle({kBar + 1e-4, 0}, {2 * kBar + 1e-4, kThickness})};
  blocks.blocks[1].material = 1;
  Settings settings = standard_settings(analysis);
  settings.standard.restitution = restitution;
  return mixed_scene_of(blocks, {0, 1}, analysis, settings, half_rows, CoverFunctions::derived);
}

struct Collision {
  double time = 0;       ///< in contact
  double exchanged = 0;  ///< speed of the first bar over that of the second before
  double lost = 0;       ///< fraction of the energy
};

Collision collision_of(const Scene& scene, double dt) {
  StandardStepper stepper(scene);
  Collision found;
  double met = 0;
  while (stepper.state().time < 0.012) {
    run_to(stepper, stepper.state().time + dt);
    const auto& closed = stepper.motion().closed.all();
    if (closed.empty()) continue;
    if (met == 0) met = stepper.state().time;
    found.time = stepper.state().time - met;
  }
  const StandardScene& at_end = stepper.scene();
  const Motion& end = stepper.motion();
  std::vector<WholeBody> bars;
  for (const auto& group : at_end.groups)
    group->look_at_bodies(at_end.parts(), end.q, momentum(at_end, end.v),
                          [&](const WholeBody& bar) { bars.push_back(bar); });
  const double mass = kDensity * kBar * kThickness;
  found.exchanged = -bars[0].resultant[0] / mass / kSpeed;
  const double kinetic = mass * kSpeed * kSpeed;
  const StoredEnergy stored = stored_energy(at_end, end);
  found.lost = 1 - (stored.kinetic + stored.strain) / kinetic;
  return found;
}

// Wave theory of two equal bars (Saint-Venant 1867): they part after 2 L/c with their speeds exchanged, without loss.
// The loss of a mesh is the motion of its layer at the faces.
TEST(CoverContact, bars_on_covers_exchange_their_speeds_in_the_time_of_the_wave) {
  constexpr double kStep = 5e-5;
  double lost = 1;
  for (const int half_rows : {1, 4, 12}) {
    const Collision found = collision_of(colliding_bars(half_rows, 0, kStep), kStep);
    EXPECT_LT(found.lost, half_rows == 1 ? 0.07 : lost / 1.2) << half_rows;
    EXPECT_GE(found.lost, 0) << half_rows;
    lost = found.lost;
    if (half_rows < 12) continue;
    EXPECT_NEAR(found.time / (2 * kBar / kWaveSpeed), 1, 0.01);
    EXPECT_NEAR(found.exchanged, 1, 0.01);
  }
}

// With a restitution of their own, too, faces that meet create no energy and keep momentum.
TEST(CoverContact, bodies_on_covers_that_rebound_make_no_energy) {
  for (const double restitution : {0.0, 0.5, 1.0}) {
    const Ledger ledger = ledger_of(colliding_bars(2, restitution, 1e-4), 0.012);
    const double kinetic = kDensity * kBar * kThickness * kSpeed * kSpeed;
    EXPECT_NEAR(ledger.rows.front().stored.kinetic, kinetic, 1e-9 * kinetic);
    const LedgerRow& end = ledger.rows.back();
    EXPECT_LE(end.stored.kinetic + end.stored.strain, kinetic * (1 + 1e-9)) << restitution;
    EXPECT_GE(end.stored.kinetic + end.stored.strain, 0.9 * kinetic) << restitution;
    EXPECT_LE(support::sums_of(ledger).energy_closure(), 1e-9) << restitution;
    EXPECT_LE(support::sums_of(ledger).linear_momentum_closure(), 1e-12) << restitution;
  }
}

// A square that falls on a soft slab whose foot is fixed by the problem itself.
Scene square_over_slab(int half_rows) {
  Analysis analysis = plain_analysis(1e-3, 1);
  analysis.block_materials.push_back(analysis.block_materials[0]);
  analysis.block_materials[0].youngs_modulus = 1e7;
  Blocks blocks;
  blocks.blocks = {rectangle({-3, -1}, {3, 0}), rectangle({-0.5, 0.05}, {0.5, 1.05})};
  blocks.blocks[1].material = 1;
  Settings settings = settings_for(analysis, Enforcement::penalty);
  settings.standard.start = StartRule::sudden;  // the slab swings
  Scene scene = mixed_scene_of(blocks, {0}, analysis, settings, half_rows, CoverFunctions::derived);
  Continuum held = *scene.model.continuum;
  held.prescribed.push_back({{{-3, -1}, {3, -1}}, Held::both, {}});
  held.prescribed.back().value = [](Point, Point) { return Point{}; };
  scene.model.continuum = std::make_shared<Continuum>(std::move(held));
  return scene;
}

// The slab stays on its support under the impact. Energy only falls, the energy balance has every loss, and a finer
// mesh loses less.
TEST(CoverContact, a_body_held_by_its_supports_takes_up_what_falls_on_it) {
  const double fallen = kDensity * kGravity * 0.05;
  double lost = fallen;
  for (const int half_rows : {2, 6}) {
    const Ledger ledger = ledger_of(square_over_slab(half_rows), 0.125);
    EXPECT_LE(support::sums_of(ledger).energy_closure(), 1e-9) << half_rows;
    EXPECT_TRUE(ledger.scope.has_supports);
    double least = ledger.rows.front().stored.total();
    for (const LedgerRow& row : ledger.rows) {
      EXPECT_LE(row.stored.total(), least + 1e-3 * fallen) << half_rows << ' ' << row.time;
      least = std::min(least, row.stored.total());
    }
    EXPECT_LT(-least, half_rows == 2 ? 0.4 * fallen : 0.7 * lost) << half_rows;
    lost = -least;
  }
}

}  // namespace
}  // namespace keyblock::cover_contact_test
