// A run of stages that was saved before any step continues to the same bytes.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>

#include "result/describe.hpp"
#include "run/checkpoint.hpp"
#include "run/steppers.hpp"
#include "tests/support/staged_runs.hpp"

namespace keyblock::stages_resumed_test {
namespace {

using support::box;
using support::column;
using support::squares_on_covers;
using support::stage_of;

/// A column that slides and loses a block, is cut, bolted, held and released.
Scene eventful() {
  Problem problem = column(3);
  problem.analysis->joint_materials[0].friction_angle_deg = 10;
  problem.stages = {stage_of(5), stage_of(4, "dig"), stage_of(4, "cut"), stage_of(4, "bolt"), stage_of(5, "hold")};
  problem.stages[0].settings = {{"gravity.x", "4"}};
  problem.stages[1].excavations = {{box({-0.5, 2}, {2.5, 4}), 0, {}}};
  problem.stages[2].cuts = {{{{-1, 0.4}, {3, 0.6}}, 0, {}}};
  problem.stages[3].bolts = {{{{1, 1.5}, {2.5, -0.5}}, 1e6, 0, 1e3, 0, {}}};
  problem.stages[4].held = {{{1, 0.2}, {}}};
  problem.stages[4].removed_bolts = {{0, {}}};
  return prepare(problem, "standard", {}).scene;
}

Scene eventful_on_covers() {
  Problem problem = squares_on_covers(CoverFunctions::derived);
  problem.stages = {stage_of(3), stage_of(3, "dig"), stage_of(3, "bolt"), stage_of(3, "hold")};
  problem.stages[0].settings = {{"gravity.x", "4"}};
  problem.stages[1].excavations = {{box({0.7, 1.4}, {1.3, 3}), 0, {}}};
  problem.stages[2].bolts = {{{{0.5, 1.5}, {1.5, 0.5}}, 1e6, 0, 1e3, 0, {}}};
  problem.stages[3].held = {{{0.3, 1.7}, {}}};
  problem.stages[3].removed_bolts = {{0, {}}};
  return prepare(problem, "standard", {}).scene;
}

/// Blocks that get covers, other ones, are excavated, bolted and made blocks again.
Problem eventful_mixed_problem() {
  Problem problem = column(3);
  problem.analysis->block_materials.push_back(problem.analysis->block_materials.front());
  std::get<Blocks>(problem.geometry).blocks[2].material = 1;
  problem.stages = {stage_of(3), stage_of(3, "mesh"), stage_of(3, "dig"), stage_of(3, "finer"), stage_of(3, "blocks")};
  problem.stages[0].settings = {{"gravity.x", "4"}};
  problem.stages[1].mesh.emplace();
  problem.stages[1].mesh->side = 0.7;
  problem.stages[1].mesh->materials = {{1}};
  problem.stages[2].excavations = {{box({0.7, 1.4}, {1.3, 3}), 0, {}}};
  problem.stages[3].mesh = problem.stages[1].mesh;
  problem.stages[3].mesh->side = 0.5;
  problem.stages[3].bolts = {{{{0.4, 1.5}, {1.5, 0.5}}, 1e6, 0, 1e3, 0, {}}};
  problem.stages[4].mesh = problem.stages[1].mesh;
  problem.stages[4].mesh->materials = {{0}};
  problem.stages[4].mesh->side = 1.2;
  return problem;
}

Scene eventful_mixed() {
  return prepare(eventful_mixed_problem(), "standard", {}).scene;
}

/// The same of rock so weak that it yields under its weight: the memory of points is transferred from blocks to covers
/// and back.
Scene eventful_in_yielding_rock() {
  Problem problem = eventful_mixed_problem();
  Strength strength;
  strength.values = {.cohesion = 2000, .friction_deg = 20, .dilation_deg = 10};
  for (BlockMaterial& material : problem.analysis->block_materials)
    material.strength = std::make_shared<const Strength>(strength);
  return prepare(problem, "standard", {}).scene;
}

/// Linear solutions with excavations in load steps 2 and 4.
Scene dug_at_once() {
  Problem problem = squares_on_covers(CoverFunctions::derived);
  problem.analysis->velocity_carry_over = 0;
  problem.analysis->step_count = 5;
  problem.covers->displacements = {{{{0, 0}, {2, 0}}, Held::both, {}, {}, {}, {}},
                                   {{{0, 1}, {0, 2}}, Held::both, {}, {}, {}, {}}};
  problem.covers->excavations = {{2, box({0.7, 1.4}, {1.3, 3}), {}, 0}, {4, box({1.6, 0.5}, {3, 1.2}), {}, 0}};
  const Scene scene = prepare(problem, "standard", {}).scene;
  EXPECT_TRUE(scene.is_untouched);
  return scene;
}

/// The same of elastoplastic rock that yields under its weight.
Problem dug_problem(CoverFunctions functions) {
  Problem problem = squares_on_covers(functions);
  Strength strength;
  strength.values = {.cohesion = 300000, .friction_deg = 30, .dilation_deg = 30};
  for (BlockMaterial& material : problem.analysis->block_materials)
    material.strength = std::make_shared<const Strength>(strength);
  problem.analysis->velocity_carry_over = 0;
  problem.analysis->step_count = 5;
  problem.covers->displacements = {{{{0, 0}, {2, 0}}, Held::both, {}, {}, {}, {}},
                                   {{{0, 1}, {0, 2}}, Held::both, {}, {}, {}, {}}};
  problem.covers->excavations = {{2, box({0.7, 1.4}, {1.3, 3}), {}, 0}, {4, box({1.6, 0.5}, {3, 1.2}), {}, 0}};
  return problem;
}

Scene dug_in_yielding_rock() {
  const Scene scene = prepare(dug_problem(CoverFunctions::constant), "standard", {}).scene;
  EXPECT_TRUE(scene.is_untouched && may_yield(scene));
  return scene;
}

std::string bytes_of(Stepper& stepper) {
  Archive archive;
  stepper.save(archive);
  return checkpoint_bytes(archive);
}

}  // namespace

constexpr std::array kNames{"blocks", "covers", "linear", "mixed", "yielding", "yielding_mixed"};

class ResumedStages : public testing::TestWithParam<Scene (*)()> {};

TEST_P(ResumedStages, left_before_any_step_they_go_on_to_the_same_bytes) {
  const Scene scene = GetParam()();
  const std::unique_ptr<Stepper> whole = stepper_for(scene);
  std::vector<std::string> saved;
  while (!whole->is_done()) {
    saved.push_back(bytes_of(*whole));
    const auto made = whole->advance();
    ASSERT_TRUE(std::holds_alternative<StepReport>(made)) << std::get<StepFailure>(made).reason;
  }
  ASSERT_EQ(static_cast<int>(saved.size()), scene.settings.step_count);
  saved.push_back(bytes_of(*whole));
  // A state that reaches the next step continues from there as that does: one step of each is enough.
  for (std::size_t step = 0; step + 1 < saved.size(); ++step) {
    Archive archive = archive_of_checkpoint("checkpoint.h5", saved[step]);
    const std::unique_ptr<Stepper> again = restored_stepper(scene, archive);
    EXPECT_TRUE(bytes_of(*again) == saved[step]) << step;
    again->advance();
    EXPECT_TRUE(bytes_of(*again) == saved[step + 1]) << step;
  }
}

TEST(YieldingStages, rock_has_yielded_as_blocks_and_on_covers) {
  const std::unique_ptr<Stepper> stepper = stepper_for(eventful_in_yielding_rock());
  while (!stepper->is_done()) {
    ASSERT_TRUE(std::holds_alternative<StepReport>(stepper->advance()));
    const int step = stepper->state().step;
    if (step != 3 && step != 12) continue;  // the last of blocks alone, and with the finer mesh
    const std::optional<PlasticTotals> totals = stepper->plastic_totals();
    ASSERT_TRUE(totals.has_value());
    EXPECT_GT(totals->yielded, 0) << step;
  }
}

// Three scenes lock alike.
TEST(YieldingStages, what_all_scenes_are_warned_of_is_said_once) {
  Problem problem = dug_problem(CoverFunctions::derived);
  const Warnings warnings = prepare(problem, "standard", {}).warnings;
  EXPECT_EQ(std::ranges::count_if(warnings, [](const Warning& w) { return w.name == "functions_lock"; }), 1);
}

INSTANTIATE_TEST_SUITE_P(Scenes, ResumedStages,
                         testing::Values(eventful, eventful_on_covers, dug_at_once, eventful_mixed,
                                         dug_in_yielding_rock, eventful_in_yielding_rock),
                         [](const auto& one) { return std::string(kNames.at(one.index)); });

}  // namespace keyblock::stages_resumed_test
