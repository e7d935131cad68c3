// Through every change of a scene the ledger closes: excavations under contact, a tunnel, a thousand changes in
// flight.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "formats/case.hpp"
#include "geometry/polygon.hpp"
#include "run/stages/rock.hpp"
#include "tests/support/staged_runs.hpp"

namespace keyblock::stages_ledger_test {
namespace {

using support::plain_analysis;
using support::rectangle;
using support::stage_of;
using support::Told;
using support::told_of;
using support::wall_with_opening;

/// A random change of blocks that fly: the largest is cut in two, or one goes, is of another material, or is bolted to
/// another.
Stage random_change(const Rock& rock, std::mt19937& dice) {
  const std::vector<BlockPolygon>& blocks = rock.blocks.blocks;
  const auto below = [&](std::size_t count) { return std::uniform_int_distribution<std::size_t>(0, count - 1)(dice); };
  const auto size_of = [](const BlockPolygon& block) { return area(points_of(block.outer)); };
  const auto middle_of = [](const BlockPolygon& block) { return centroid(points_of(block.outer)); };
  const BlockPolygon& block = blocks[below(blocks.size())];
  Stage stage = stage_of(1);
  switch (below(4)) {
    case 0: {
      const BlockPolygon& largest = *std::ranges::max_element(blocks, {}, size_of);
      const double angle = 2 * std::numbers::pi * std::uniform_real_distribution<double>(0, 1)(dice);
      const Point reach{1.1 * std::cos(angle), 1.1 * std::sin(angle)};
      stage.cuts = {{{middle_of(largest) - reach, middle_of(largest) + reach}, 0, {}}};
      break;
    }
    case 1:
      stage.excavations = {{points_of(block.outer), 0, {}}};
      break;
    case 2:
      stage.block_materials = {{points_of(block.outer), 1, {}}};
      break;
    default:
      const BlockPolygon& other = blocks[below(blocks.size())];
      if (&other != &block) stage.bolts = {{{middle_of(block), middle_of(other)}, 1e5, 0, 10, 0, {}}};
      if (!rock.blocks.bolts.empty() && below(2) == 0) stage.removed_bolts = {{rock.identities.bolts.front(), {}}};
  }
  return stage;
}

/// The same, or faces are glued or come apart, and blocks are given covers, a finer or coarser mesh, or none any more.
Stage random_change_of_meshes(const Rock& rock, std::mt19937& dice) {
  const auto below = [&](int count) { return std::uniform_int_distribution<int>(0, count - 1)(dice); };
  Stage stage = below(5) == 0 ? stage_of(1) : random_change(rock, dice);
  if (below(4) == 0) stage.joint_materials = {{0, 1, {}}, {1, 0, {}}};
  if (below(2) == 0) {
    stage.mesh.emplace();
    stage.mesh->side = std::uniform_real_distribution<double>(0.7, 1.5)(dice);
    if (below(3) > 0) stage.mesh->materials = {{below(2)}};
  }
  return stage;
}

}  // namespace

class StagesUnderContact : public testing::TestWithParam<const char*> {};

TEST_P(StagesUnderContact, close_the_ledger_of_an_excavation_in_four_stages) {
  const Told told = told_of(wall_with_opening(), {{"enforcement", GetParam()}});
  EXPECT_EQ(told.outcome.scenes.size(), 4U);
  EXPECT_EQ(told.outcome.steps, 120);
  const LedgerSums sums = sums_of(told.ledger);
  EXPECT_LT(sums.energy_closure(), 1e-10);
  EXPECT_NE(told.ledger.rows.back().flow.change, 0);
}

INSTANTIATE_TEST_SUITE_P(Enforcements, StagesUnderContact, testing::Values("lagrange", "penalty", "augmented"),
                         [](const auto& one) { return std::string(one.param); });

// Notched blocks of a tunnel: a corner that two convex pieces of a block meet was two contacts with one memory, and the
// energy was off by a tenth.
TEST(StagesLedger, closes_for_the_tunnel) {
  const std::string file = std::string(KEYBLOCK_SOURCE_DIR) + "/docs/tunnel.json";
  const Problem problem = check(formats::load_case({file}).problem).problem;
  const Told told = told_of(problem, {{"basis", "rigid"}, {"start", "sudden"}});
  EXPECT_EQ(told.outcome.scenes.size(), 4U);
  EXPECT_LT(sums_of(told.ledger).energy_closure(), 1e-10);
}

TEST(StagesLedger, closes_through_a_thousand_random_changes_in_flight) {
  Problem problem;
  Blocks all;
  for (int i = 0; i < 12; ++i)
    for (int j = 0; j < 12; ++j) all.blocks.push_back(rectangle({2.0 * i, 2.0 * j}, {2.0 * i + 1.5, 2.0 * j + 1.4}));
  problem.analysis = plain_analysis(1e-3, 1);
  problem.analysis->joint_materials[0].friction_angle_deg = 30;
  BlockMaterial& rock = problem.analysis->block_materials[0];
  BlockMaterial other = rock;
  rock.initial_velocity = {1, -0.5, 0.8};
  other.initial_velocity = {-1, 0.5, -0.8};
  problem.analysis->block_materials.push_back(other);
  for (std::size_t b = 0; b < all.blocks.size(); b += 2) all.blocks[b].material = 1;
  problem.geometry = all;
  std::mt19937 dice(20);
  problem.stages = {stage_of(5)};
  problem.stages[0].settings = {{"gravity.x", "0"}, {"gravity.y", "0"}};
  Rock now = rock_of(all, *problem.analysis);
  for (int i = 0; i < 1000; ++i) {
    problem.stages.push_back(random_change(now, dice));
    now = changed(now, problem.stages.back()).rock;
  }
  const Told told = told_of(problem);
  EXPECT_EQ(told.outcome.end, RunEnd::finished);
  EXPECT_EQ(told.outcome.scenes.size(), 1001U);
  const LedgerSums sums = sums_of(told.ledger);
  EXPECT_LT(sums.linear_momentum_closure(), 1e-12);
  // Angular momentum closes to 5e-6 here without any change too: impacts of blocks that deform.
  EXPECT_LT(sums.energy_closure(), 1e-7);
}

class RandomMeshes : public testing::TestWithParam<unsigned> {};

// Ten times a hundred: cut and dug on and on, rock soon is dust.
TEST_P(RandomMeshes, the_ledger_closes_through_a_hundred_random_changes_in_flight) {
  Problem problem;
  Blocks all;
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j) all.blocks.push_back(rectangle({2.0 * i, 2.0 * j}, {2.0 * i + 1.5, 2.0 * j + 1.4}));
  problem.analysis = plain_analysis(1e-3, 1);
  problem.analysis->joint_materials.push_back(problem.analysis->joint_materials[0]);
  problem.analysis->joint_materials[1].cohesion = problem.analysis->joint_materials[1].tensile_strength = 1e5;
  BlockMaterial& rock = problem.analysis->block_materials[0];
  BlockMaterial other = rock;
  rock.initial_velocity = {1, -0.5, 0.8};
  other.initial_velocity = {-1, 0.5, -0.8};
  problem.analysis->block_materials.push_back(other);
  for (std::size_t b = 0; b < all.blocks.size(); b += 2) all.blocks[b].material = 1;
  problem.geometry = all;
  std::mt19937 dice(GetParam());
  problem.stages = {stage_of(1)};
  problem.stages[0].settings = {{"gravity.x", "0"}, {"gravity.y", "0"}};
  Rock now = rock_of(all, *problem.analysis);
  for (int i = 0; i < 100; ++i) {
    problem.stages.push_back(random_change_of_meshes(now, dice));
    now = changed(now, problem.stages.back()).rock;
  }
  const Told told = told_of(problem);
  EXPECT_EQ(told.outcome.end, RunEnd::finished);
  EXPECT_EQ(told.outcome.scenes.size(), 101U);
  for (std::size_t i = 1; i < problem.stages.size(); ++i) {
    if (!problem.stages[i].excavations.empty()) continue;
    const LedgerRow& before = told.ledger.rows[i];
    const LedgerRow& after = told.ledger.rows[i + 1];
    EXPECT_LT(distance(after.momentum.linear, before.momentum.linear), 1e-12 * before.momentum_size.linear) << i;
  }
  EXPECT_LT(sums_of(told.ledger).energy_closure(), 1e-7);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomMeshes, testing::Range(1U, 11U));

}  // namespace keyblock::stages_ledger_test
