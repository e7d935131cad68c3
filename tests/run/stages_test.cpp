// A run of stages continues from the stage before: unchanged blocks keep place, velocity, strain and contact forces,
// and the energy balance closes through every change.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/ledger_sums.hpp"
#include "tests/support/staged_runs.hpp"

namespace keyblock::stages_test {
namespace {

using support::box;
using support::column;
using support::kGravity;
using support::kWeight;
using support::plain_analysis;
using support::rectangle;
using support::stage_of;
using support::Told;
using support::told_of;

/// Blocks that fly and rotate, without supports.
Problem flying() {
  Problem problem;
  Blocks all;
  all.blocks = {rectangle({0, 0}, {2, 1}), rectangle({5, 0}, {6, 3}), rectangle({0, 5}, {3, 6})};
  problem.geometry = all;
  problem.analysis = plain_analysis(1e-3, 1);
  BlockMaterial& rock = problem.analysis->block_materials[0];
  rock.initial_velocity = {0.7, -0.3, 0.9};
  BlockMaterial other = rock;
  other.initial_velocity = {-0.5, 1, -1.7};
  problem.analysis->block_materials.push_back(other);
  std::get<Blocks>(problem.geometry).blocks[1].material = 1;
  return problem;
}

std::string error_of(const Problem& problem, const std::string& profile = "standard") {
  try {
    prepare(problem, profile, {});
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

}  // namespace

TEST(Stages, without_changes_are_the_run_in_one) {
  Problem one = column(2);
  one.analysis->step_count = 20;
  Problem several = column(2);
  several.stages = {stage_of(7, "first"), stage_of(13)};
  const Told whole = told_of(one);
  const Told parts = told_of(several);
  EXPECT_EQ(parts.outcome.steps, 20);
  for (int block = 1; block <= 3; ++block) {
    EXPECT_NEAR(parts.at_end(block).centroid.y, whole.at_end(block).centroid.y, 1e-15);
    EXPECT_NEAR(parts.at_end(block).stress.yy, whole.at_end(block).stress.yy, 1e-9 * kWeight);
  }
  ASSERT_EQ(parts.outcome.scenes.size(), 2U);
  EXPECT_EQ(parts.outcome.scenes[0].last_step, 7);
  EXPECT_EQ(parts.outcome.scenes[1].first_step, 7);
  EXPECT_EQ(parts.outcome.scenes[1].last_step, 20);
}

// The mean stress of the lower block is that of its own half weight and of all above.
TEST(Stages, of_statics_the_block_below_bears_what_is_left) {
  Problem problem = column(2);
  problem.analysis->velocity_carry_over = 0;
  problem.stages = {stage_of(2), stage_of(2, "the upper block goes")};
  problem.stages[1].excavations = {{box({-0.5, 1}, {2.5, 3}), 0, {}}};
  const Told told = told_of(problem);
  const auto before = std::ranges::find(told.frames, 2, &Frame::step);
  ASSERT_NE(before, told.frames.end());
  EXPECT_NEAR(element_of(*before, 1)->stress.yy, -1.5 * kWeight, 1e-6 * kWeight);
  EXPECT_NEAR(told.at_end(2).stress.yy, -0.5 * kWeight, 1e-6 * kWeight);
  EXPECT_EQ(element_of(told.frames.back(), 2), nullptr);
  Problem alone = column(1);
  alone.analysis->velocity_carry_over = 0;
  alone.analysis->step_count = 2;
  EXPECT_NEAR(told_of(alone).at_end(2).displacement.y, told.at_end(2).displacement.y, 1e-12);
}

TEST(Stages, a_stage_ends_where_forces_are_balanced) {
  Problem problem = column(2);
  problem.stages = {stage_of(5), stage_of(20000, "to rest")};
  problem.stages[1].excavations = {{box({-0.5, 1}, {2.5, 3}), 0, {}}};
  problem.stages[1].equilibrium = 1e-3;
  const Told told = told_of(problem, {{"mass_damping", "20"}});
  ASSERT_EQ(told.outcome.scenes.size(), 2U);
  EXPECT_TRUE(told.outcome.scenes[1].is_balanced);
  EXPECT_LT(told.outcome.steps, 20005);
  EXPECT_NEAR(told.at_end(2).stress.yy, -0.5 * kWeight, 2e-3 * kWeight);
}

// A push to and fro begins gently; the stage must not end before its table does.
TEST(Stages, a_stage_lasts_as_long_as_its_loads_change) {
  Problem problem = column(1, 5e-3);
  problem.stages = {stage_of(2000, "shaken")};
  problem.stages[0].equilibrium = 1e-3;
  Scene scene = prepare(problem, "standard", {{"mass_damping", "20"}}).scene;
  TimeCurve& shaking = scene.settings.body_acceleration.curve;
  shaking.times = {0, 1, 2};
  shaking.values = {{0, 0}, {0.5, 0}, {0, 0}};
  const Told told = told_of(scene);
  ASSERT_EQ(told.outcome.scenes.size(), 1U);
  EXPECT_TRUE(told.outcome.scenes[0].is_balanced);
  EXPECT_GE(told.outcome.time, 2 - 1e-9);
  EXPECT_LT(told.outcome.time, 3);
}

TEST(Stages, a_cut_in_flight_keeps_momentum_and_energy) {
  Problem problem = flying();
  problem.stages = {stage_of(30), stage_of(30, "cut")};
  problem.stages[1].cuts = {{{{-1, 0.3}, {3, 0.8}}, 0, {}}, {{{4, 1}, {7, 2.2}}, 0, {}}};
  const Told told = told_of(problem);
  EXPECT_EQ(told.frames.back().elements.size(), 5U);
  const LedgerSums sums = support::sums_of(told.ledger);
  EXPECT_LT(sums.linear_momentum_closure(), 1e-12);
  EXPECT_LT(sums.angular_momentum_closure(), 1e-10);
  EXPECT_LT(sums.energy_closure(), 1e-8);
  // The affine field of a block continues in its pieces: the cut itself changes nothing.
  EXPECT_LT(std::abs(told.ledger.rows.back().flow.change), 1e-9 * sums.largest_energy());
}

TEST(Stages, a_block_that_goes_takes_its_energy_and_momentum_with_it) {
  Problem problem = flying();
  problem.stages = {stage_of(30), stage_of(30, "gone")};
  problem.stages[1].excavations = {{box({4, -1}, {7, 4}), 0, {}}};
  const Told told = told_of(problem);
  const LedgerSums sums = support::sums_of(told.ledger);
  EXPECT_LT(sums.linear_momentum_closure(), 1e-12);
  EXPECT_LT(sums.angular_momentum_closure(), 1e-10);
  EXPECT_LT(sums.energy_closure(), 1e-8);
  const double mass = 3 * 2500;
  const double inertia = mass * (1 + 9) / 12;
  const double t = 0.03;
  const double vy = 1 - kGravity * t;
  const double kinetic = mass * (0.5 * 0.5 + vy * vy) / 2 + inertia * 1.7 * 1.7 / 2;
  const double gravity = mass * kGravity * (1 * t - kGravity * t * t / 2);
  EXPECT_NEAR(told.ledger.rows.back().flow.change, -(kinetic + gravity), 1e-4 * kinetic);
}

TEST(Stages, pieces_have_numbers_and_an_origin_and_the_largest_keeps_its_own) {
  Problem problem = flying();
  problem.stages = {stage_of(2), stage_of(2)};
  problem.stages[1].cuts = {{{{-1, 0.3}, {3, 0.3}}, 0, {}}};
  const Told told = told_of(problem);
  const Frame& end = told.frames.back();
  ASSERT_EQ(end.elements.size(), 4U);
  EXPECT_EQ(end.elements[0].number, 0);
  EXPECT_NEAR(end.elements[0].mass, 2500 * 1.4, 1e-9);
  EXPECT_EQ(end.elements[1].number, 3);
  EXPECT_EQ(end.elements[1].origin, 0);
  EXPECT_EQ(end.elements[2].number, 1);
  ASSERT_EQ(told.rows.back().points.size(), 4U);
  EXPECT_EQ(told.rows.front().points.size(), 3U);
}

// A bolt that is placed while the block slides has its pretension at once.
TEST(Stages, a_measured_point_keeps_its_number_when_another_goes) {
  Problem problem = column(2);
  std::get<Blocks>(problem.geometry).measured_points = {{{1, 1.5}, 2, {}}, {{1, 0.25}, 1, {}}};
  problem.stages = {stage_of(3), stage_of(3, "the upper block goes")};
  problem.stages[1].excavations = {{box({-0.5, 1}, {2.5, 3}), 0, {}}};
  const Told told = told_of(problem);
  ASSERT_NE(measured_point_of(told.frames.front(), 0), nullptr);
  EXPECT_EQ(measured_point_of(told.frames.back(), 0), nullptr);
  ASSERT_NE(measured_point_of(told.frames.back(), 1), nullptr);
  EXPECT_NEAR(measured_point_of(told.frames.back(), 1)->position.y, 0.25, 1e-5);
}

TEST(Stages, a_bolt_has_its_pretension_where_it_is_put_in) {
  Problem problem = column(1);
  problem.analysis->joint_materials[0].friction_angle_deg = 0;
  problem.stages = {stage_of(200), stage_of(1, "bolted")};
  problem.stages[0].settings = {{"gravity.x", "1"}};
  problem.stages[1].settings = {{"gravity.x", "0"}};
  problem.stages[1].bolts = {{{{1, 0.5}, {2.5, -0.5}}, 1e6, 0, 4e3, 0, {}}};
  const Told told = told_of(problem);
  EXPECT_GT(told.at_end(2).displacement.x, 0.019);  // t²/2 at 0.2
  ASSERT_EQ(told.rows.back().bolt_forces.size(), 1U);
  // A step moves the block by 0.2 mm and thus the bolt by less: 200 N of the pretension.
  EXPECT_NEAR(told.rows.back().bolt_forces[0], 4e3, 200);
  EXPECT_TRUE(told.rows.front().bolt_forces.empty());
}

TEST(Stages, a_point_is_held_where_it_is_and_released_again) {
  Problem problem = column(1);
  problem.analysis->joint_materials[0].friction_angle_deg = 0;
  problem.stages = {stage_of(100), stage_of(100, "held"), stage_of(100, "free")};
  problem.stages[0].settings = {{"gravity.x", "2"}};
  problem.stages[1].held = {{{1, 0.5}, {}}, {{1.5, 0.5}, {}}};
  problem.stages[2].released = {{box({0, 0}, {2, 1}), {}}};
  const Told told = told_of(problem);
  const auto at = [&](int step) {
    return element_of(*std::ranges::find(told.frames, step, &Frame::step), 1)->displacement.x;
  };
  EXPECT_NEAR(at(100), 0.01, 1e-6);
  EXPECT_NEAR(at(200), at(100), 1e-5);
  EXPECT_NEAR(at(300) - at(200), 0.01, 1e-5);
}

TEST(Stages, forces_come_and_go) {
  Problem problem = flying();
  problem.analysis->gravity = 0;
  problem.analysis->block_materials[0].initial_velocity = {};
  problem.stages = {stage_of(10), stage_of(10), stage_of(10)};
  problem.stages[0].settings = {{"gravity.y", "0"}};
  problem.stages[1].forces = {{{1, 0.5}, {5000, 0}, {}}};
  problem.stages[2].removes_forces = true;
  const Told told = told_of(problem);
  EXPECT_NEAR(told.at_end(1).velocity.x, 5000.0 / 5000 * 0.01, 1e-9);
}

TEST(Stages, materials_change) {
  Problem problem = column(1);
  problem.analysis->velocity_carry_over = 0;
  BlockMaterial soft = problem.analysis->block_materials[0];
  soft.youngs_modulus /= 10;
  problem.analysis->block_materials.push_back(soft);
  problem.stages = {stage_of(1), stage_of(1)};
  problem.stages[1].block_materials = {{box({0, 0}, {2, 1}), 1, {}}};
  const Told told = told_of(problem);
  const auto height = [&](const Frame& frame) {
    const auto& loop = element_of(frame, 1)->loops[0];
    return loop[2].y - loop[1].y;
  };
  const auto first = std::ranges::find(told.frames, 1, &Frame::step);
  EXPECT_NEAR((1 - height(told.frames.back())) / (1 - height(*first)), 10, 1e-3);
}

TEST(Stages, a_friction_that_is_lost_lets_a_block_slide) {
  Problem problem = column(1);
  problem.analysis->joint_materials.push_back({});
  problem.analysis->joint_materials[1].friction_angle_deg = 5;
  problem.stages = {stage_of(100), stage_of(100)};
  problem.stages[0].settings = {{"gravity.x", "3"}};
  problem.stages[1].joint_materials = {{0, 1, {}}};
  const Told told = told_of(problem);
  const double t = 0.1;
  const double a = 3 - kGravity * std::tan(5 * std::numbers::pi / 180);
  EXPECT_NEAR(told.at_end(2).displacement.x, a * t * t / 2, 0.02 * a * t * t / 2);
}

// The block needs tan φ = 0.31. That of its joint falls from 0.84 to 0.25 by a factor, and to 0.09 by another material.
TEST(Stages, statics_finds_no_rest_on_a_joint_that_became_weak) {
  const auto reason = [](const Stage& second) {
    Problem problem = column(1);
    problem.analysis->joint_materials.push_back({});
    problem.analysis->joint_materials[1].friction_angle_deg = 5;
    problem.stages = {stage_of(2), second};
    problem.stages[0].settings = {{"gravity.x", "3"}, {"motion", "static"}};
    return run(prepare(problem, "standard", {}).scene, 1000, {}).reason;
  };
  Stage same = stage_of(2), weaker = same, other = same;
  weaker.settings = {{"joint_strength_factor", "0.3"}};
  other.joint_materials = {{0, 1, {}}};
  EXPECT_EQ(reason(same), "");
  for (const Stage& weak : {weaker, other}) EXPECT_NE(reason(weak).find("accelerates"), std::string::npos);
}

// A block that is pressed against a ceiling is glued to it, loses its base, hangs, and falls once the glue is gone.
TEST(Stages, joints_are_glued_and_unglued) {
  Problem problem = column(1);
  Blocks& blocks = std::get<Blocks>(problem.geometry);
  blocks.blocks.push_back(rectangle({-1, 1}, {3, 2}));
  blocks.fixed_points.push_back({{-0.5, 1.5}, 2, {}});
  blocks.fixed_points.push_back({{2.5, 1.5}, 2, {}});
  for (BlockVertex& vertex : blocks.blocks[1].outer)
    if (vertex.position == Point{0, 1}) vertex.joint_material = 1;  // of the edge that arrives there, the upper one
  for (BlockVertex& vertex : blocks.blocks[2].outer)
    if (vertex.position == Point{3, 1}) vertex.joint_material = 1;  // the lower edge of the ceiling
  std::vector<JointMaterial>& joints = problem.analysis->joint_materials;
  joints.resize(3);
  joints[2].cohesion = joints[2].tensile_strength = 1e6;
  problem.stages = {stage_of(20), stage_of(20, "glued"), stage_of(100, "hangs"), stage_of(100, "falls")};
  problem.stages[0].settings = {{"gravity.y", "5"}};
  problem.stages[1].joint_materials = {{1, 2, {}}};
  problem.stages[2].settings = {{"gravity.y", "-9.81"}};
  problem.stages[2].excavations = {{box({-1.5, -1.5}, {3.5, 0}), 0, {}}};
  problem.stages[3].joint_materials = {{2, 1, {}}};
  const Told told = told_of(problem);
  const auto at = [&](int step) {
    return element_of(*std::ranges::find(told.frames, step, &Frame::step), 1)->displacement.y;
  };
  EXPECT_NEAR(at(140), 0, 1e-4);
  EXPECT_NEAR(at(240) - at(140), -kGravity * 0.1 * 0.1 / 2, 1e-4);
}

TEST(Stages, a_longer_step_of_a_profile_makes_fewer_steps_of_a_stage) {
  Problem problem = column(1);
  problem.stages = {stage_of(10), stage_of(7)};
  problem.stages[1].duration = 0.004;
  const Scene scene = prepare(problem, "draft", {}).scene;
  const double share = scene.settings.time_step / problem.analysis->time_step;
  EXPECT_GT(share, 1);
  EXPECT_EQ(scene.end.steps, static_cast<int>(std::lround(10 / share)));
  EXPECT_EQ(scene.next->scene.end.steps, static_cast<int>(std::lround(4 / share)));
  EXPECT_EQ(scene.settings.step_count, scene.end.steps + scene.next->scene.end.steps);
}

TEST(Stages, what_cannot_be_is_an_error) {
  const auto with = [](auto change) {
    Problem problem = column(2);
    problem.stages = {stage_of(1), stage_of(1)};
    change(problem.stages[1]);
    return error_of(problem);
  };
  EXPECT_NE(with([](Stage& s) {
              s.excavations = {{box({-9, -9}, {9, 9}), 0, {}}};
            }).find("not excavated"),
            std::string::npos);
  EXPECT_NE(with([](Stage& s) {
              s.block_materials = {{box({0, 0}, {2, 1}), 1, {}}};
            }).find("expected a block material from 1 to 1, found 2"),
            std::string::npos);
  EXPECT_NE(with([](Stage& s) {
              s.removed_bolts = {{0, {}}};
            }).find("expected a bolt from 1 to 0, found 1"),
            std::string::npos);
  EXPECT_NE(with([](Stage& s) {
              s.settings = {{"body_acceleration_file", "acc.csv"}};
            }).find("expected body_acceleration_file in the settings of the whole run"),
            std::string::npos);
  EXPECT_NE(with([](Stage& s) {
              s.held = {{{50, 50}, {}}};
            }).find("a point of held_points in a block, found none at (50, 50)"),
            std::string::npos);
  Problem problem = column(1);
  problem.stages = {stage_of(1)};
  EXPECT_NE(error_of(problem, "legacy").find("expected dynamics standard for stages"), std::string::npos);
  EXPECT_NE(with([](Stage& s) {
              s.excavations = {{{{0, 1}, {2, 2}, {2, 1}, {0, 2}}, 0, {}}};
            }).find("an outline that does not cross or touch itself, found sides 1 and 3"),
            std::string::npos);
  EXPECT_NE(with([](Stage& s) {
              s.bolts = {{{{1, 0.5}, {1, 0.5}}, 1e6, 0, 0, 0, {}}};
            }).find("a bolt with a length"),
            std::string::npos);
}

TEST(Stages, what_a_stage_asks_for_and_nothing_answers_to_is_said) {
  const auto warnings_of = [](auto change) {
    Problem problem = column(2);
    problem.stages = {stage_of(1), stage_of(1)};
    change(problem.stages[1]);
    std::string sentences;
    for (const Warning& warning : prepare(problem, "standard", {}).warnings)
      if (warning.name == "stage_without_effect") sentences += warning.sentence + '\n';
    return sentences;
  };
  EXPECT_EQ(warnings_of([](Stage& s) {
              s.excavations = {{box({50, 50}, {60, 60}), 0, {}}};
            }),
            "nothing lies within the outline: nothing is excavated\n");
  EXPECT_EQ(warnings_of([](Stage& s) {
              s.cuts = {{{{0.5, 0.5}, {1, 0.6}}, 0, {}}};
            }),
            "no line passes through a block from side to side: nothing is cut\n");
  EXPECT_EQ(warnings_of([](Stage& s) {
              s.block_materials = {{box({50, 50}, {60, 60}), 0, {}}};
            }),
            "no block has its centroid within the outline: no material changes\n");
  EXPECT_EQ(warnings_of([](Stage& s) {
              s.released = {{box({50, 50}, {60, 60}), {}}};
            }),
            "no fixed point lies within the outline\n");
  EXPECT_EQ(warnings_of([](Stage& s) { s.excavations = {{box({-0.5, 1}, {2.5, 3}), 0, {}}}; }), "");
}

}  // namespace keyblock::stages_test
