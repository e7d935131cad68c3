// Draws the changes; the rock of each stage is known without a run. See random_changes.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/random_changes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "geometry/polygon.hpp"
#include "run/prepare.hpp"
#include "run/run.hpp"
#include "run/stages/rock.hpp"
#include "tests/support/ledger_sums.hpp"
#include "tests/support/scenes.hpp"

namespace keyblock::support {
namespace {

Stage stage_of_steps(int steps) {
  Stage stage;
  stage.steps = steps;
  return stage;
}

Point middle_of(const BlockPolygon& block) {
  return centroid(points_of(block.outer));
}

double size_of(const BlockPolygon& block) {
  return area(points_of(block.outer));
}

/// A line through the middle of a block, longer than the block.
Segment line_through(const BlockPolygon& block, std::mt19937& dice) {
  const double angle = 2 * std::numbers::pi * std::uniform_real_distribution<double>(0, 1)(dice);
  const Point reach{1.1 * std::cos(angle), 1.1 * std::sin(angle)};
  return {middle_of(block) - reach, middle_of(block) + reach};
}

/// The largest is cut in two, or one is removed, gets another material, or is bolted to another.
Stage change_of_blocks(const Rock& rock, std::mt19937& dice) {
  const std::vector<BlockPolygon>& blocks = rock.blocks.blocks;
  const auto below = [&](std::size_t count) { return std::uniform_int_distribution<std::size_t>(0, count - 1)(dice); };
  const BlockPolygon& block = blocks[below(blocks.size())];
  Stage stage = stage_of_steps(1);
  switch (below(4)) {
    case 0: {
      stage.cuts = {{line_through(*std::ranges::max_element(blocks, {}, size_of), dice), 0, {}}};
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

Stage change_of_meshes(const Rock& rock, std::mt19937& dice) {
  const auto below = [&](int count) { return std::uniform_int_distribution<int>(0, count - 1)(dice); };
  Stage stage = below(5) == 0 ? stage_of_steps(1) : change_of_blocks(rock, dice);
  if (below(4) == 0) stage.joint_materials = {{0, 1, {}}, {1, 0, {}}};
  if (below(2) == 0) {
    stage.mesh.emplace();
    stage.mesh->side = std::uniform_real_distribution<double>(0.7, 1.5)(dice);
    if (below(3) > 0) stage.mesh->materials = {{below(2)}};
  }
  return stage;
}

/// Lines do not cut bodies of one mesh: a strip through the largest is excavated.
Stage change_of_one_mesh(const Rock& rock, std::mt19937& dice) {
  const auto below = [&](std::size_t count) { return std::uniform_int_distribution<std::size_t>(0, count - 1)(dice); };
  const std::vector<BlockPolygon>& blocks = rock.blocks.blocks;
  Stage stage = stage_of_steps(1);
  if (below(4) == 0) stage.joint_materials = {{0, 1, {}}, {1, 0, {}}};
  const std::size_t choice = below(6);
  if (choice < 3) {
    const Segment line = line_through(*std::ranges::max_element(blocks, {}, size_of), dice);
    const Point along = line.end - line.start;
    const Point half = 0.05 / length(along) * Point{-along.y, along.x};
    stage.excavations = {{{line.start - half, line.end - half, line.end + half, line.start + half}, 0, {}}};
  } else if (choice == 3 && blocks.size() > 2) {
    stage.excavations = {{points_of(blocks[below(blocks.size())].outer), 0, {}}};
  } else if (choice == 4) {
    stage.block_materials = {{points_of(blocks[below(blocks.size())].outer), 1, {}}};
  }
  return stage;
}

Stage change_of(ChangingBodies bodies, const Rock& rock, std::mt19937& dice) {
  switch (bodies) {
    case ChangingBodies::blocks:
      return change_of_blocks(rock, dice);
    case ChangingBodies::meshes:
      return change_of_meshes(rock, dice);
    case ChangingBodies::one_mesh:
      return change_of_one_mesh(rock, dice);
  }
  return {};
}

}  // namespace

Problem random_changes(ChangingBodies bodies, int rows, int count, unsigned seed, CoverFunctions functions) {
  Problem problem;
  Blocks all;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < rows; ++j) all.blocks.push_back(rectangle({2.0 * i, 2.0 * j}, {2.0 * i + 1.5, 2.0 * j + 1.4}));
  problem.analysis = plain_analysis(1e-3, 1);
  if (bodies == ChangingBodies::blocks) {
    problem.analysis->joint_materials[0].friction_angle_deg = 30;
  } else {
    problem.analysis->joint_materials.push_back(problem.analysis->joint_materials[0]);
    problem.analysis->joint_materials[1].cohesion = problem.analysis->joint_materials[1].tensile_strength = 1e5;
  }
  BlockMaterial& rock = problem.analysis->block_materials[0];
  BlockMaterial other = rock;
  rock.initial_velocity = {1, -0.5, 0.8};
  other.initial_velocity = {-1, 0.5, -0.8};
  problem.analysis->block_materials.push_back(other);
  for (std::size_t b = 0; b < all.blocks.size(); b += 2) all.blocks[b].material = 1;
  problem.geometry = all;
  if (bodies != ChangingBodies::blocks) {
    CoverPlan plan;
    plan.functions = functions;
    if (bodies == ChangingBodies::one_mesh) plan.mesh.side = 0.7;
    problem.covers = plan;
  }
  std::mt19937 dice(seed);
  problem.stages = {stage_of_steps(bodies == ChangingBodies::blocks ? 5 : 1)};
  problem.stages[0].settings = {{"gravity.x", "0"}, {"gravity.y", "0"}};
  Rock now = rock_of(all, *problem.analysis);
  for (int i = 0; i < count; ++i) {
    problem.stages.push_back(change_of(bodies, now, dice));
    now = changed(now, problem.stages.back()).rock;
  }
  return problem;
}

ChangesTold told_of_changes(const Problem& problem) {
  Ledger ledger;
  Observer observer;
  observer.on_ledger = [&](const LedgerRow& row) { ledger.rows.push_back(row); };
  ChangesTold told;
  Scene scene;
  try {
    scene = prepare(problem, "standard", {}).scene;
  } catch (const InputError& error) {  // covers that a random cut leaves without mass
    told.why = told.refused = error.what();
    return told;
  }
  const RunOutcome outcome = run(scene, 1000, observer);
  if (outcome.end != RunEnd::finished) told.why = outcome.reason.empty() ? "it did not end" : outcome.reason;
  told.scenes = outcome.scenes.size();
  const int first = problem.stages[0].steps;
  for (std::size_t i = 1; i < problem.stages.size(); ++i) {
    const std::size_t row = static_cast<std::size_t>(first) + i;
    if (!problem.stages[i].excavations.empty() || row >= ledger.rows.size()) continue;
    const LedgerRow& before = ledger.rows[row - 1];
    const double moved = distance(ledger.rows[row].momentum.linear, before.momentum.linear);
    told.at_change = std::max(told.at_change, moved / before.momentum_size.linear);
  }
  const LedgerSums sums = support::sums_of(ledger);
  told.momentum = sums.linear_momentum_closure();
  told.energy = sums.energy_closure();
  return told;
}

}  // namespace keyblock::support
