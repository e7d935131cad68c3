// Stages that give blocks a mesh, or another one, beside DDA blocks that stay.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/support/ledger_sums.hpp"
#include "tests/support/staged_runs.hpp"

namespace keyblock {
namespace {

using support::box;
using support::column;
using support::stage_of;
using support::Told;
using support::told_of;

MeshPlan mesh_of(double side, std::vector<MeshedMaterial> materials = {}) {
  MeshPlan mesh;
  mesh.side = side;
  mesh.materials = std::move(materials);
  return mesh;
}

/// Blocks that turn and fly apart without weight; the second material is that of every other block.
Problem in_flight(double dt = 1e-4) {
  Problem problem = column(3, dt);
  Blocks& blocks = std::get<Blocks>(problem.geometry);
  blocks.fixed_points.clear();
  Analysis& analysis = *problem.analysis;
  analysis.gravity = 0;
  analysis.velocity_carry_over = 1;
  analysis.block_materials.push_back(analysis.block_materials.front());
  for (BlockMaterial& material : analysis.block_materials) {
    material.unit_weight = 0;
    material.initial_velocity = {2, 1, 0.7};
  }
  analysis.block_materials[1].initial_velocity = {-1, 3, -1.1};
  blocks.blocks[2].material = 1;
  return problem;
}

}  // namespace

// Newton: no force acts on bodies in flight, with any unknowns. The angular momentum of a block is that of its
// unstrained shape, that of a mesh is of the places of its points: at a change they differ by the strain.
TEST(MixedStages, blocks_given_covers_in_flight_keep_momentum_and_energy) {
  for (const CoverFunctions functions :
       {CoverFunctions::constant, CoverFunctions::derived, CoverFunctions::linear, CoverFunctions::quadratic}) {
    SCOPED_TRACE(static_cast<int>(functions));
    Problem problem = in_flight();
    problem.covers = CoverPlan{};
    problem.covers->functions = functions;
    problem.stages = {stage_of(5), stage_of(5, "mesh"), stage_of(5, "finer"), stage_of(5, "blocks again")};
    problem.stages[1].mesh = mesh_of(1.1, {{0}});
    problem.stages[2].mesh = mesh_of(0.8);
    problem.stages[3].mesh = mesh_of(0.9, {{1}});
    const Told told = told_of(problem);
    EXPECT_LT(support::sums_of(told.ledger).energy_closure(), 1e-8);
    const LedgerRow& first = told.ledger.rows.front();
    for (const LedgerRow& row : told.ledger.rows) {
      EXPECT_LT(distance(row.momentum.linear, first.momentum.linear), 1e-12 * first.momentum_size.linear);
      EXPECT_LT(std::abs(row.flow.change), 1e-6 * first.stored.kinetic);
    }
    for (const std::size_t step : {5U, 10U, 15U}) {
      const double before = told.ledger.rows[step].momentum.angular;
      EXPECT_LT(std::abs(told.ledger.rows[step + 1].momentum.angular - before), 1e-7 * first.momentum_size.angular);
    }
  }
}

// A stable column stays stable: the mesh changes the stress within.
TEST(MixedStages, a_block_given_covers_under_load_bears_it) {
  Problem problem = column(3);
  problem.stages = {stage_of(40), stage_of(60, "mesh")};
  problem.analysis->block_materials.push_back(problem.analysis->block_materials.front());
  std::get<Blocks>(problem.geometry).blocks[2].material = 1;
  problem.stages[1].mesh = mesh_of(0.6, {{1}});
  for (const char* motion : {"dynamic", "static"}) {
    const Told told = told_of(problem, {{"motion", motion}});
    const Frame& first = told.frames.front();
    const Frame& end = told.frames.back();
    ASSERT_GT(end.elements.size(), first.elements.size()) << motion;
    double force = 0;
    double area = 0;
    for (const ElementFrame& element : end.elements)
      if (element.origin == 2) {
        force += element.stress.yy * element.area;
        area += element.area;
      }
    EXPECT_NEAR(area, 2, 1e-3) << motion;
    // Half of its own weight and that of the block on it.
    EXPECT_NEAR(force / area, -1.5 * support::kWeight, 0.05 * support::kWeight) << motion;
  }
}

// Glued halves that are pulled apart stay glued when they get meshes with nodes at other places.
TEST(MixedStages, faces_stay_bonded_when_a_mesh_parts_them) {
  Problem problem = column(2);
  Blocks& blocks = std::get<Blocks>(problem.geometry);
  blocks.fixed_points = {{{0.5, 1.9}, 2, {}}, {{1.5, 1.9}, 2, {}}};
  blocks.blocks.erase(blocks.blocks.begin());
  for (BlockPoint& point : blocks.fixed_points) point.block = 1;
  JointMaterial& joint = problem.analysis->joint_materials[0];
  joint.cohesion = joint.tensile_strength = 1e6;  // forty times the weight below it
  problem.analysis->block_materials.push_back(problem.analysis->block_materials.front());
  blocks.blocks[0].material = 1;
  problem.stages = {stage_of(20), stage_of(40, "mesh"), stage_of(40, "finer")};
  problem.stages[1].mesh = mesh_of(0.6, {{1}});
  problem.stages[2].mesh = mesh_of(0.35);
  const Told told = told_of(problem);
  for (const ElementFrame& element : told.frames.back().elements) EXPECT_LT(std::abs(element.displacement.y), 1e-3);
  joint.cohesion = joint.tensile_strength = 0;
  EXPECT_LT(told_of(problem).frames.back().elements.front().displacement.y, -0.01);
}

TEST(MixedStages, meshed_blocks_are_dug_and_cut) {
  Problem problem = column(3);
  problem.stages = {stage_of(20), stage_of(20, "dig"), stage_of(20, "cut")};
  problem.stages[0].mesh = mesh_of(0.8, {{0}});
  problem.stages[1].excavations = {{box({-0.5, 2.4}, {2.5, 3.5}), 0, {}}};
  problem.stages[2].cuts = {{{{-1, 0.5}, {3, 0.6}}, 0, {}}};
  const Told told = told_of(problem);
  double area = 0;
  for (const ElementFrame& element : told.frames.back().elements) area += element.area;
  EXPECT_NEAR(area, 4 + 2 * 2.4, 1e-3);
  EXPECT_LT(support::sums_of(told.ledger).energy_closure(), 1e-8);
}

TEST(MixedStages, a_mesh_for_no_block_is_said) {
  Problem problem = column(2);
  problem.stages = {stage_of(5), stage_of(5)};
  problem.stages[1].mesh = mesh_of(0.5, {{7}});
  const Warnings warnings = prepare(problem, "standard", {}).warnings;
  EXPECT_EQ(std::ranges::count(warnings, "stage_without_effect", &Warning::name), 1);
}

TEST(MixedStages, a_bolt_that_is_gone_already_is_said) {
  Problem problem = column(2);
  problem.stages = {stage_of(5), stage_of(5), stage_of(5)};
  problem.stages[0].bolts = {{{{1, 0.4}, {1, 1.5}}, 1e6, 0, 1e3, 0, {}}};
  problem.stages[1].removed_bolts = {{0, {}}};
  EXPECT_EQ(prepare(problem, "standard", {}).warnings, Warnings{});
  problem.stages[2].removed_bolts = {{0, {}}};
  const Warnings warnings = prepare(problem, "standard", {}).warnings;
  EXPECT_EQ(std::ranges::count(warnings, "stage_without_effect", &Warning::name), 1);
}

TEST(MixedStages, what_cannot_be_is_an_error) {
  Problem problem = column(2);
  problem.stages = {stage_of(5), stage_of(5)};
  problem.stages[1].mesh = mesh_of(0.5);
  problem.covers = CoverPlan{};
  problem.covers->mesh = mesh_of(0.5);
  EXPECT_THROW(prepare(problem, "standard", {}), InputError);
}

}  // namespace keyblock
