// The compatible start of blocks on springs: forces that fit the gaps, so that nothing oscillates, creeps or is kicked.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/rest/compatible_start.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "tests/support/standard_scenes.hpp"

namespace keyblock::compatible_start_test {
namespace {

using support::plain_analysis;
using support::radians;
using support::standard_scene_of;
using support::standard_settings;
using support::turned_rectangle;

constexpr double kWidth = 1;
constexpr double kStep = 1e-3;
constexpr double kBolt = 1e6;  // stiffness

/// A column of b/h = 0.9 tan a on a slope a of 10 degrees.
double height() {
  return kWidth / (0.9 * std::tan(radians(10)));
}

Blocks column_on_slope() {
  const double slope = radians(10);
  Blocks scene;
  scene.blocks = {turned_rectangle({0, -2}, {20, 0}, -slope), turned_rectangle({6, 0}, {6 + kWidth, height()}, -slope)};
  scene.fixed_points = {{turned(Point{1, -1}, -slope), 0, {}}, {turned(Point{19, -1}, -slope), 0, {}}};
  return scene;
}

/// A block of 2 m² under a fixed one, on two bolts of 1 MN/m at a quarter and three quarters of its width.
Blocks hung_block(double pretension, double strength) {
  Blocks scene;
  scene.blocks = {support::rectangle({0, 4}, {2, 5}), support::rectangle({0, 0}, {2, 1})};
  scene.fixed_points = {{{0.1, 4.5}, 0, {}}, {{1.9, 4.5}, 0, {}}};
  for (const double x : {0.5, 1.5}) scene.bolts.push_back({{{x, 4}, {x, 1}}, 0, 1, kBolt, strength, pretension});
  return scene;
}
constexpr double kWeight = 2 * 2500 * 9.81;
constexpr double kOwnStretch = 1.3e-6;  // m

void move(Blocks& blocks, Point by) {
  for (BlockPolygon& block : blocks.blocks)
    for (BlockVertex& corner : block.outer) corner.position = corner.position + by;
  for (BlockPoint& point : blocks.fixed_points) point.position = point.position + by;
}

Analysis of_hung_block() {
  Analysis analysis = plain_analysis(kStep, 100);
  analysis.block_materials[0].density = 2500;
  analysis.block_materials[0].unit_weight = 2500 * 9.81;
  return analysis;
}

double drop_of(const Blocks& blocks, double time) {
  const Analysis analysis = of_hung_block();
  StandardStepper stepper(standard_scene_of(blocks, analysis, standard_settings(analysis)));
  const double from = stepper.state().elements[ElementIndex{1}].centroid.y;
  support::run_to(stepper, time);
  return from - stepper.state().elements[ElementIndex{1}].centroid.y;
}

/// Angular acceleration of the rigid column about its toe: (b² + h²)/3 θ'' = g/2 √(b² + h²) sin θ, θ from the vertical
/// to the line from toe to centroid.
double first_acceleration() {
  const double theta = radians(10) - std::atan(kWidth / height());
  return 1.5 * 9.81 * std::sin(theta) / std::hypot(kWidth, height());
}

/// `count` cubes of 1 m in a row, bonded to each other and to a fixed one.
Scene bonded_row(int count) {
  Blocks blocks;
  for (int i = 0; i <= count; ++i) blocks.blocks.push_back(support::rectangle({i - 1.0, 0}, {i * 1.0, 1}));
  blocks.fixed_points = {{{-0.9, 0.1}, 0, {}}, {{-0.9, 0.9}, 0, {}}};
  Analysis analysis = plain_analysis(kStep, 100);
  analysis.joint_materials[0].cohesion = analysis.joint_materials[0].tensile_strength = 1e9;
  return standard_scene_of(blocks, analysis, standard_settings(analysis));
}

BlockPolygon block_of(const std::vector<Point>& corners) {
  BlockPolygon block;
  for (const Point& at : corners) block.outer.push_back({at});
  return block;
}

/// Block 3, 2 m high and 2 m wide at its top, between two fixed ones to which it is bonded. It widens downwards, with
/// sides at `lean` from the vertical.
Scene key_block(double lean, double strength) {
  const double bottom = 1 + 2 * std::tan(lean);
  Blocks blocks;
  blocks.blocks = {block_of({{-8, 0}, {-bottom, 0}, {-1, 2}, {-8, 2}}), block_of({{bottom, 0}, {8, 0}, {8, 2}, {1, 2}}),
                   block_of({{-bottom, 0}, {bottom, 0}, {1, 2}, {-1, 2}})};
  for (const double y : {0.5, 1.5})
    for (const int side : {0, 1}) blocks.fixed_points.push_back({{side == 0 ? -7.0 : 7.0, y}, side, {}});
  Analysis analysis = plain_analysis(0.01, 100);
  analysis.joint_materials[0] = {20, strength, strength, {}};
  return standard_scene_of(blocks, analysis, standard_settings(analysis));
}
}  // namespace

// A heel pressed into its spring by the shift of the toe would throw the column over at 7e-4 rad/s, 30 times its speed
// after these steps.
TEST(CompatibleStart, the_heel_of_a_toppling_column_on_springs_gives_it_no_spin) {
  for (const BlockBasis basis : {BlockBasis::rigid, BlockBasis::affine}) {
    Analysis analysis = plain_analysis(kStep, 100);
    analysis.penalty_factor = 10;
    analysis.joint_materials[0].friction_angle_deg = 50;
    Settings settings = standard_settings(analysis);
    settings.basis = basis;
    settings.standard.enforcement = Enforcement::penalty;
    StandardStepper stepper(standard_scene_of(column_on_slope(), analysis, settings));
    constexpr double kTime = 20 * kStep;
    support::run_to(stepper, kTime);
    const double spin = stepper.state().elements[ElementIndex{1}].velocity[2];
    const double expected = -first_acceleration() * kTime;
    EXPECT_NEAR(spin, expected, 0.05 * std::abs(expected)) << "basis " << static_cast<int>(basis);
  }
}

// Three points per edge leave one of the normal forces open to a rigid block. Part of an oscillation makes it slip by μ
// g/ω for ever if friction just holds.
TEST(CompatibleStart, a_block_on_springs_stays_where_friction_just_holds_it) {
  for (const BlockBasis basis : {BlockBasis::rigid, BlockBasis::affine}) {
    for (const double penalty_factor : {1, 10, 100}) {
      Analysis analysis = plain_analysis(1e-2, 100);
      analysis.penalty_factor = penalty_factor;
      analysis.joint_materials[0].friction_angle_deg = 30;
      Settings settings = standard_settings(analysis);
      settings.basis = basis;
      settings.standard.enforcement = Enforcement::penalty;
      StandardStepper stepper(standard_scene_of(support::block_on_slope(radians(30)), analysis, settings));
      const State start = stepper.state();
      support::run_to(stepper, 1);
      EXPECT_LT(length(support::travel(stepper, start, 1)), 1e-8) << "springs of " << penalty_factor << " E";
    }
  }
}

TEST(CompatibleStart, the_start_is_reported) {
  Analysis analysis = plain_analysis(kStep, 1);
  analysis.joint_materials[0].friction_angle_deg = 50;
  Settings settings = standard_settings(analysis);
  const StandardStepper asked(standard_scene_of(column_on_slope(), analysis, settings));
  EXPECT_EQ(asked.start_report().made, "compatible");
  EXPECT_EQ(asked.start_report().why, "");
  EXPECT_LE(asked.start_report().misfit, 1e-6);
  settings.standard.start = StartRule::sudden;
  EXPECT_EQ(StandardStepper(standard_scene_of(column_on_slope(), analysis, settings)).start_report().made,
            "as the file has it");
}

// A block of initial stress s between fixed walls presses its springs together by d each: (s - p) L / E = 2 d. It began
// without forces, bounced between the walls, and gained energy at 10 ms.
TEST(CompatibleStart, a_stressed_block_on_springs_is_at_rest_between_walls) {
  constexpr double kStress = 1e6, kModulus = 1e8;
  for (const double dt : {1e-3, 1e-2}) {
    Analysis analysis = plain_analysis(dt, 1);
    analysis.gravity = 0;
    analysis.block_materials[0].youngs_modulus = kModulus;
    analysis.block_materials[0].poissons_ratio = 0;
    analysis.block_materials[0].initial_stress = {-kStress, 0, 0};
    Blocks blocks;
    blocks.blocks = {support::rectangle({0, 0}, {1, 1}), support::rectangle({-2, -1}, {0, 2}),
                     support::rectangle({1, -1}, {3, 2})};
    blocks.fixed_points = {{{-1.5, 0}, 1, {}}, {{-1.5, 1}, 1, {}}, {{2.5, 0}, 2, {}}, {{2.5, 1}, 2, {}}};
    Settings settings = standard_settings(analysis);
    settings.standard.enforcement = Enforcement::penalty;
    StandardStepper stepper(standard_scene_of(blocks, analysis, settings));
    const State start = stepper.state();
    support::run_to(stepper, 0.1);
    EXPECT_LT(length(support::travel(stepper, start, 0)), 1e-9) << dt;
    double force = 0, overlap = 0;
    for (const ContactFrame& contact : stepper.contacts()) {
      force += contact.normal_force / 2;
      overlap -= contact.gap / 2;
    }
    EXPECT_GT(force, 0.1 * kStress) << dt;
    EXPECT_NEAR((kStress - force) / kModulus, overlap, 1e-6 * overlap) << dt;
  }
}

// Frictionless blocks between walls, on a floor, with the stress -s both ways. Their top is free, so they end at
// vertical stress 0 and horizontal stress -(1 - nu) s (Hooke, plane stress). Few blocks begin at the equilibrium of
// statics, many where the forces of the stress lead them.
TEST(CompatibleStart, a_stressed_mass_begins_where_its_free_face_lets_it) {
  constexpr double kStress = 1e5;
  for (const auto& [n, far] : {std::pair(2, 0.0), {6, 0.0}, {6, 1e4}}) {
    Analysis analysis = plain_analysis(1e-3, 1);
    analysis.gravity = 0;
    analysis.plane_strain = false;
    analysis.block_materials[0].youngs_modulus = 1e9;
    analysis.block_materials[0].poissons_ratio = 0.25;
    analysis.penalty_factor = 1e4;  // springs take no length
    analysis.block_materials[0].initial_stress = {-kStress, -kStress, 0};
    analysis.joint_materials[0].friction_angle_deg = 0;
    const auto size = static_cast<double>(n);
    Blocks blocks;
    blocks.blocks = {support::rectangle({-2, -1}, {0, size + 1}), support::rectangle({size, -1}, {size + 2, size + 1}),
                     support::rectangle({0, -1}, {size, 0})};
    for (const int fixed : {0, 1, 2})
      for (const double part : {0.2, 0.8}) {
        const auto& corners = blocks.blocks[static_cast<std::size_t>(fixed)].outer;
        blocks.fixed_points.push_back(
            {corners[0].position + part * (corners[2].position - corners[0].position), fixed, {}});
      }
    for (int i = 0; i < n * n; ++i) {
      const Point low{static_cast<double>(i % n), static_cast<double>(i / n)};
      blocks.blocks.push_back(support::rectangle(low, low + Point{1, 1}));
    }
    move(blocks, {far, far});
    StandardStepper stepper(standard_scene_of(blocks, analysis, standard_settings(analysis)));
    const State start = stepper.state();
    support::run_to(stepper, 0.02);
    for (int i = 3; i < 3 + n * n; ++i) {
      EXPECT_LT(length(support::travel(stepper, start, i)), 1e-8) << n << ", block " << i;
      const Stress stress = stepper.state().elements[ElementIndex(i)].stress;
      EXPECT_NEAR(stress.xx, -0.75 * kStress, 1e-3 * kStress) << n << ", block " << i;
      EXPECT_NEAR(stress.yy, 0, 1e-3 * kStress) << n << ", block " << i;
    }
  }
}

// Frictionless blocks in a row on a floor, from a wall to a free end, with the stress -s along it. Each grows by s/E of
// its length (Hooke), so that the last one begins at n s/E: 4 % of a block for the longest row. A block that slides far
// away from it begins as drawn, and changes nothing.
TEST(CompatibleStart, a_stressed_row_begins_where_its_free_end_lets_it) {
  constexpr double kStress = 1e6, kModulus = 1e9;
  struct Row {
    int n;
    double far;
    bool has_slider;
  };
  for (const auto& [n, far, has_slider] :
       {Row{15, 0, false}, {25, 0, false}, {40, 0, false}, {40, 1e4, false}, {25, 0, true}, {40, 1e4, true}}) {
    Analysis analysis = plain_analysis(1e-2, 1);
    analysis.block_materials[0].density = 2500;
    analysis.block_materials[0].youngs_modulus = kModulus;
    analysis.block_materials[0].poissons_ratio = 0;
    analysis.block_materials[0].initial_stress = {-kStress, 0, 0};
    analysis.joint_materials[0].friction_angle_deg = 0;
    Blocks blocks;
    blocks.blocks = {support::rectangle({-2, -1}, {n + 4.0, 0}), support::rectangle({-2, 0}, {0, 1})};
    blocks.fixed_points = {{{-1.5, -0.5}, 0, {}}, {{n + 3.5, -0.5}, 0, {}}, {{-1.5, 0.2}, 1, {}}, {{-0.5, 0.8}, 1, {}}};
    for (int i = 0; i < n; ++i) blocks.blocks.push_back(support::rectangle({i + 0.0, 0}, {i + 1.0, 1}));
    if (has_slider) {
      const double slope = radians(30);
      blocks.blocks.push_back(turned_rectangle({-60, -1}, {-40, 0}, slope));
      blocks.blocks.push_back(turned_rectangle({-45, 0}, {-44, 1}, slope));
      for (const double x : {-59.5, -40.5}) blocks.fixed_points.push_back({turned(Point{x, -0.5}, slope), n + 2, {}});
    }
    const Point offset{far, far};
    move(blocks, offset);
    StandardStepper stepper(standard_scene_of(blocks, analysis, standard_settings(analysis)));
    const State start = stepper.state();
    if (has_slider) {
      const Point drawn = turned(Point{-44.5, 0.5}, radians(30)) + offset;
      EXPECT_LT(distance(start.elements[ElementIndex(n + 3)].centroid, drawn), 1e-3) << n;
    }
    const double way = start.elements[ElementIndex(n + 1)].centroid.x - far - (n - 0.5);
    EXPECT_NEAR(way, (n - 0.5) * kStress / kModulus, 1e-3 * n * kStress / kModulus) << n << ", " << far;
    support::run_to(stepper, 0.2);
    EXPECT_LT(length(support::travel(stepper, start, n + 1)), 1e-5) << n << ", " << far;
    EXPECT_NEAR(stepper.state().elements[ElementIndex(n + 1)].stress.xx, 0, 1e-3 * kStress) << n << ", " << far;
  }
}

// Each bolt carries half the weight, and has the length of that; the block, stretched by its own weight, by 1.2 µm. A
// bolt whose pretension is half the weight gets this alone.
TEST(CompatibleStart, a_hung_block_is_in_balance_with_its_bolts) {
  const Analysis analysis = of_hung_block();
  for (const double pretension : {0.0, 0.3 * kWeight, 0.5 * kWeight}) {
    const Blocks blocks = hung_block(pretension, 0);
    StandardStepper stepper(standard_scene_of(blocks, analysis, standard_settings(analysis)));
    for (const BoltState& bolt : stepper.state().bolts) EXPECT_NEAR(bolt.force, kWeight / 2, 1e-9 * kWeight);
    const double sunk = 0.5 - stepper.state().elements[ElementIndex{1}].centroid.y;
    EXPECT_NEAR(sunk, (kWeight / 2 - pretension) / kBolt, kOwnStretch) << pretension;
    EXPECT_NEAR(drop_of(blocks, 0.1), 0, pretension < 0.5 * kWeight ? 1e-12 : 2 * kOwnStretch) << pretension;
  }
}

// Two per cent either side of the carried load.
TEST(CompatibleStart, a_bolt_that_the_weight_breaks_is_not_balanced) {
  EXPECT_NEAR(drop_of(hung_block(0, 1.02 * kWeight / 2), 0.1), 0, 1e-12);
  const double omega = std::sqrt(2 * kBolt / (kWeight / 9.81));
  EXPECT_NEAR(drop_of(hung_block(0, 0.98 * kWeight / 2), 0.02), 9.81 / (omega * omega) * (1 - std::cos(omega * 0.02)),
              2e-5);
}

// Contacts carry what they can: the bolts of a block on a floor keep the values of the file, and so does a pretension
// that pulls.
TEST(CompatibleStart, bolts_that_the_loads_do_not_stretch_stay_as_they_are) {
  const Analysis analysis = of_hung_block();
  Blocks scene = hung_block(100, 0);
  scene.blocks.push_back(support::rectangle({-1, -1}, {3, 0}));
  scene.fixed_points.push_back({{-0.5, -0.5}, 2, {}});
  scene.fixed_points.push_back({{2.5, -0.5}, 2, {}});
  StandardStepper stepper(standard_scene_of(scene, analysis, standard_settings(analysis)));
  for (const BoltState& bolt : stepper.state().bolts)
    EXPECT_NEAR(bolt.force, 100, 3) << "the block gives by 2.4 µm under its weight";
}

// A block of a millionth of the mass between two heavy ones. Forces must not be judged by their effect on the light
// one: then none of the weight was carried, and shifts left 4 % of the gaps. Springs let the column oscillate by 1 %
// for a second.
TEST(CompatibleStart, a_light_block_between_heavy_ones_bears_the_upper_one) {
  constexpr double kHeavy = 2.6e6, kLight = 2.6;
  for (const Enforcement enforcement : {Enforcement::lagrange, Enforcement::penalty}) {
    Blocks scene;
    scene.blocks = {support::rectangle({-5, -1}, {5, 0}), support::rectangle({0, 0}, {1, 1}),
                    support::rectangle({0, 1}, {1, 2}), support::rectangle({0, 2}, {1, 3})};
    scene.blocks[2].material = 1;
    scene.fixed_points = {{{-4, -0.5}, 0, {}}, {{4, -0.5}, 0, {}}};
    Analysis analysis = plain_analysis(2e-3, 100);
    analysis.penalty_factor = 10;
    analysis.joint_materials[0].friction_angle_deg = 30;
    analysis.block_materials.push_back(analysis.block_materials[0]);
    for (const std::size_t i : {0U, 1U}) {
      analysis.block_materials[i].density = i == 0 ? kHeavy : kLight;
      analysis.block_materials[i].unit_weight = 9.81 * analysis.block_materials[i].density;
      analysis.block_materials[i].youngs_modulus = 5e10;
      analysis.block_materials[i].poissons_ratio = 0;
    }
    Settings settings = standard_settings(analysis);
    settings.standard.enforcement = enforcement;
    StandardStepper stepper(standard_scene_of(scene, analysis, settings));
    EXPECT_LT(stepper.start_report().misfit, 1e-6);
    support::run_to(stepper, 0.2);
    const Stress stress = stepper.state().elements[ElementIndex{2}].stress;
    EXPECT_NEAR(stress.yy / (9.81 * kHeavy), -1, enforcement == Enforcement::penalty ? 0.01 : 1e-5);
    EXPECT_NEAR(stress.xx / (9.81 * kHeavy), 0, 1e-5);
  }
}

// Three bolts are one more than statics needs: each pulls by its stiffness, and together they carry the weight.
TEST(CompatibleStart, three_bolts_share_the_weight_by_their_stiffness) {
  const Analysis analysis = of_hung_block();
  for (const double middle : {1.0, 10.0, 0.1}) {
    Blocks blocks = hung_block(0, 0);
    blocks.bolts.push_back({{{1, 4}, {1, 1}}, 0, 1, middle * kBolt, 0, 0});
    StandardStepper stepper(standard_scene_of(blocks, analysis, standard_settings(analysis)));
    const std::vector<BoltState> bolts = stepper.state().bolts;
    for (const std::size_t i : {0U, 1U, 2U})
      EXPECT_NEAR(bolts[i].force, kWeight * (i == 2 ? middle : 1) / (2 + middle), 1e-3 * kWeight) << middle;
    EXPECT_NEAR(bolts[0].force + bolts[1].force + bolts[2].force, kWeight, 1e-5 * kWeight) << middle;
  }
}

// Weight that presses a block through itself, and lengths whose forces underflow, must not give frames of NaN or of
// inverted blocks.
TEST(CompatibleStart, a_start_that_is_none_leaves_the_scene_as_drawn_and_ends_the_run) {
  Blocks blocks;
  blocks.blocks = {support::rectangle({0, -1}, {10, 0}), support::rectangle({1, 0}, {2, 1})};
  blocks.fixed_points = {{{1, -0.5}, 0, {}}, {{9, -0.5}, 0, {}}};
  Analysis analysis = plain_analysis(kStep, 10);
  analysis.block_materials[0].unit_weight = 1e12;
  Settings settings = standard_settings(analysis);
  settings.gravity = {0, -1e12 / 2500};
  StandardStepper stepper(standard_scene_of(blocks, analysis, settings));
  EXPECT_FALSE(impossible(stepper.state()));
  EXPECT_EQ(stepper.state().elements[ElementIndex{1}].centroid, (Point{1.5, 0.5}));
  const auto made = stepper.advance();
  ASSERT_TRUE(std::holds_alternative<StepFailure>(made));
  const std::string reason = std::get<StepFailure>(made).reason;
  EXPECT_NE(reason.find("no start under the first loads: block 2"), std::string::npos) << reason;
}

// A row of cubes with one strain each bends by shear alone. Its last centroid sinks by Σ V_i / (G A) times 1 m, and by
// half of that in its own cube; V_i = γ (n - i + 1/2) is the mean shear of cube i.
TEST(CompatibleStart, bonded_blocks_begin_as_statics_leaves_them) {
  constexpr int kCubes = 4;
  StandardStepper stepper(bonded_row(kCubes));
  support::run_to(stepper, 0.02);
  const double shear_modulus = 5e9 / (2 * (1 + 0.25));
  double expected = 0;
  for (int i = 1; i <= kCubes; ++i) expected += (i < kCubes ? 1 : 0.5) * 24525 * (kCubes - i + 0.5) / shear_modulus;
  EXPECT_NEAR((0.5 - stepper.state().elements[ElementIndex{kCubes}].centroid.y) / expected, 1, 1e-3);
}

// Without any tension, cohesion carries 2 c H over the weight, 1.26 to 2.03 of it here.
TEST(CompatibleStart, a_bonded_key_block_stays_in_its_roof) {
  for (const auto& [lean, strength] : {std::pair{15.0, 40e3}, {30.0, 80e3}, {5.0, 40e3}}) {
    StandardStepper stepper(key_block(radians(lean), strength));
    const double from = stepper.state().elements[ElementIndex{2}].centroid.y;
    support::run_to(stepper, 0.5);
    EXPECT_NEAR(stepper.state().elements[ElementIndex{2}].centroid.y, from, 1e-5) << lean;
  }
}

}  // namespace keyblock::compatible_start_test
