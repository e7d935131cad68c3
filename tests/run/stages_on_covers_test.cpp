// Stages of NMM bodies: statics, flight, contact.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/ledger_sums.hpp"
#include "tests/support/staged_runs.hpp"

namespace keyblock::stages_on_covers_test {
namespace {

using support::box;
using support::kGravity;
using support::kWeight;
using support::rectangle;
using support::squares_on_covers;
using support::stage_of;
using support::Told;
using support::told_of;
using support::wall_with_opening;

/// A bar on covers that flies and rotates, from which a piece is excavated.
Problem flying_on_covers(CoverFunctions functions) {
  Problem problem = squares_on_covers(functions);
  std::get<Blocks>(problem.geometry).blocks = {rectangle({0, 0}, {3, 1}), rectangle({5, 0}, {6, 1})};
  problem.covers->displacements.clear();
  problem.analysis->block_materials[0].initial_velocity = {0.5, -0.2, 0.7};
  problem.stages = {stage_of(20), stage_of(20, "dig")};
  problem.stages[1].excavations = {{box({0.8, 0.4}, {1.7, 2}), 0, {}}};
  return problem;
}

class StagesOnCovers : public testing::TestWithParam<CoverFunctions> {};

}  // namespace

TEST_P(StagesOnCovers, of_statics_end_where_the_scene_does_that_was_cut_so_from_the_start) {
  Problem problem = squares_on_covers(GetParam());
  problem.analysis->velocity_carry_over = 0;
  problem.stages = {stage_of(1), stage_of(1, "the upper body and a notch go")};
  const std::vector<StageExcavation> dug{{box({-0.5, 1}, {2.5, 3}), 0, {}}, {box({0.7, 0.6}, {1.3, 1.2}), 0, {}}};
  problem.stages[1].excavations = dug;
  const Told told = told_of(problem);
  Problem from_start = problem;
  from_start.stages = {stage_of(1)};
  from_start.stages[0].excavations = dug;
  const Told other = told_of(from_start);
  ASSERT_EQ(told.frames.back().elements.size(), other.frames.back().elements.size());
  double greatest = 0;
  for (std::size_t e = 0; e < other.frames.back().elements.size(); ++e) {
    const ElementFrame& one = told.frames.back().elements[e];
    const ElementFrame& two = other.frames.back().elements[e];
    greatest = std::max(greatest, length(two.displacement));
    EXPECT_LT(length(one.displacement - two.displacement), 1e-6 * 2.5e-6) << e;
  }
  EXPECT_GT(greatest, 1e-6);
}

TEST_P(StagesOnCovers, in_flight_keep_momentum_and_book_the_energy_that_goes) {
  const Told told = told_of(flying_on_covers(GetParam()));
  const LedgerSums sums = support::sums_of(told.ledger);
  EXPECT_LT(sums.linear_momentum_closure(), 1e-10);
  EXPECT_LT(sums.angular_momentum_closure(), 1e-10);
  EXPECT_LT(sums.energy_closure(), 1e-8);
  EXPECT_LT(told.frames.back().elements.size(), told.frames.front().elements.size());
}

// A removed part takes its share of the momentum, as a rigid body that rotates about the centre of the whole has it.
TEST_P(StagesOnCovers, what_goes_takes_its_own_momentum_and_no_other) {
  const Told told = told_of(flying_on_covers(GetParam()));
  const auto at = [&](int step) { return std::ranges::find(told.ledger.rows, step, &LedgerRow::step); };
  const Momentum lost{at(20)->momentum.linear - at(21)->momentum.linear, 0};
  const double dt = 1e-3;
  const Point weight{0, -kWeight * (4 - 0.9 * 0.6) * dt};  // of the rest, in the step after
  const double mass = 2500 * 0.9 * 0.6;
  const Point arm{1.25 - 1.5, 0.7 - 0.5};
  const double turn = 0.7 * 20 * dt;
  const Point now{arm.x * std::cos(turn) - arm.y * std::sin(turn), arm.x * std::sin(turn) + arm.y * std::cos(turn)};
  const Point velocity{0.5 - 0.7 * now.y, -0.2 - kGravity * 20 * dt + 0.7 * now.x};
  EXPECT_NEAR(lost.linear.x + weight.x, mass * velocity.x, 1e-4 * mass);
  EXPECT_NEAR(lost.linear.y + weight.y, mass * velocity.y, 1e-4 * mass);
}

INSTANTIATE_TEST_SUITE_P(Functions, StagesOnCovers,
                         testing::Values(CoverFunctions::constant, CoverFunctions::derived, CoverFunctions::linear),
                         [](const auto& one) { return std::string(keyblock::name_of(one.param)); });

TEST(Stages, under_contact_on_covers_close_the_ledger_of_an_excavation_in_four_stages) {
  Problem problem = wall_with_opening();
  Blocks& blocks = std::get<Blocks>(problem.geometry);
  blocks.fixed_points.clear();
  CoverPlan plan;
  plan.functions = CoverFunctions::constant;
  plan.mesh.side = 1.6;
  plan.displacements = {{{{-1, -1}, {9, -1}}, Held::both, {}, {}, {}, {}}};
  problem.covers = plan;
  for (Stage& stage : problem.stages) stage.steps = 2;
  const Told told = told_of(problem);
  EXPECT_EQ(told.outcome.steps, 8);
  EXPECT_LT(support::sums_of(told.ledger).energy_closure(), 1e-8);
}

// A change of a joint material finds the edges present by then, as it does those of blocks.
TEST(Stages, on_covers_dug_edges_are_of_the_joint_material_of_their_stage) {
  Problem problem = squares_on_covers(CoverFunctions::constant);
  problem.analysis->joint_materials.push_back(problem.analysis->joint_materials.front());
  problem.stages = {stage_of(1, "as drawn"), stage_of(1, "dig"), stage_of(1, "of another material")};
  problem.stages[0].joint_materials = {{1, 0, {}}};
  problem.stages[1].excavations = {{box({0.7, 1.4}, {1.3, 3}), 1, {}}};
  problem.stages[2].joint_materials = {{1, 0, {}}};
  const Scene scene = prepare(problem, "standard", {}).scene;
  const std::vector<const Scene*> scenes = scenes_of(scene);
  ASSERT_EQ(scenes.size(), 3U);
  for (std::size_t stage = 0; stage < 3; ++stage) {
    const Model& model = scenes[stage]->model;
    const auto at = [&](VertexIndex v) { return model.start_vertices[static_cast<std::size_t>(v.value)]; };
    int dug = 0;
    for (VertexIndex v : indices(model.vertices)) {
      if (model.vertices[v].is_inner || model.vertices[v].joint_material != 1) continue;
      ++dug;
      const Point middle = 0.5 * (at(v) + at(model.vertices[v].previous));
      const bool is_on_floor = std::abs(middle.y - 1.4) < 1e-12 && middle.x > 0.7 && middle.x < 1.3;
      const bool is_on_wall = std::abs(std::abs(middle.x - 1) - 0.3) < 1e-12 && middle.y > 1.4;
      EXPECT_TRUE(is_on_floor || is_on_wall) << middle.x << ' ' << middle.y;
    }
    EXPECT_EQ(dug > 0, stage == 1) << stage;
  }
}

}  // namespace keyblock::stages_on_covers_test
