// Cover files beside a section `covers`: their triangles are bisected at tips and points, cracks cut them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <string>

#include "cut/covers/to_cover.hpp"
#include "fracture/tip_report.hpp"
#include "geometry/polygon.hpp"
#include "model/continuum.hpp"
#include "run/bodies/planned_bodies.hpp"
#include "run/growth/solution_of.hpp"
#include "run/prepare.hpp"
#include "step/linear_stepper.hpp"
#include "tests/support/scenes.hpp"

namespace keyblock::refined_cover_file_test {
namespace {

const CrackPlan kCrack{{{0, 0}, {0.5, 0}}, {}};

/// A plate of 1 by 2 in tension, fixed by springs that carry no load.
Problem plate() {
  Problem problem;
  Blocks blocks;
  blocks.blocks = {support::rectangle({0, -1}, {1, 1})};
  problem.geometry = blocks;
  problem.analysis = support::plain_analysis(1, 1);
  problem.analysis->velocity_carry_over = 0;
  problem.analysis->gravity = 0;
  problem.analysis->block_materials[0].unit_weight = 0;
  CoverPlan plan;
  plan.contact = CoverContact::ignored;
  plan.mesh.side = 0.1;
  plan.mesh.angle_deg = 10;
  plan.tractions = {{{{0, 1}, {1, 1}}, {}, {"1", {}}, {}, {}}, {{{0, -1}, {1, -1}}, {}, {"-1", {}}, {}, {}}};
  plan.springs = {{{1, -1}, {1, 0}, 1e9, {}}, {{1, -1}, {0, 1}, 1e9, {}}, {{1, 1}, {1, 0}, 1e9, {}}};
  problem.covers = plan;
  return problem;
}

/// The same with the bodies and the mesh of `of` in a cover file.
Problem from_file(const Problem& of) {
  const PlannedBodies bodies(of);
  Problem problem = of;
  problem.geometry = to_cover(bodies.at(0), bodies.blocks());
  problem.covers->mesh = {};
  problem.covers->cracks.clear();
  return problem;
}

Scene scene_of(const Problem& problem) {
  return prepare(problem, "standard", {}).scene;
}

double area_of(const Manifold& manifold) {
  double sum = 0;
  for (const ManifoldElement& element : manifold.elements)
    for (const std::vector<Point>& loop : manifold.polygon(element)) sum += area(loop);
  return sum;
}

double mode_1(const Problem& problem) {
  LinearStepper stepper(scene_of(problem));
  EXPECT_NEAR(area_of(stepper.model().continuum->manifold), 2, 1e-12);
  if (!std::holds_alternative<StepReport>(stepper.advance())) return 0;
  const CoverSolution solution = *solution_of(stepper);
  const std::vector<CrackTip>& tips = solution.continuum.manifold.tips;
  EXPECT_EQ(tips.size(), 1U);
  const auto factors = tips.empty() ? std::nullopt : tip_factors(solution, tips.front());
  return factors ? factors->k.mode_1 : 0;
}

std::string fault_of(const Problem& problem) {
  try {
    scene_of(problem);
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

}  // namespace

TEST(RefinedCoverFile, is_bisected_at_the_tip_of_a_joint_that_ends_inside) {
  Problem by_plan = plate();
  by_plan.covers->cracks = {kCrack};
  Problem of_file = from_file(by_plan);
  by_plan.covers->mesh.tip_side = of_file.covers->mesh.tip_side = 0.003;
  const double expected = mode_1(by_plan);
  EXPECT_GT(expected, 1);
  EXPECT_NEAR(mode_1(of_file), expected, 0.005 * expected);
}

TEST(RefinedCoverFile, is_cut_by_cracks) {
  Problem by_plan = plate();
  Problem of_file = from_file(by_plan);
  by_plan.covers->cracks = of_file.covers->cracks = {kCrack};
  by_plan.covers->mesh.tip_side = of_file.covers->mesh.tip_side = 0.003;
  const double expected = mode_1(by_plan);
  EXPECT_NEAR(mode_1(of_file), expected, 0.005 * expected);
}

TEST(RefinedCoverFile, keeps_its_mesh_where_nothing_is_smaller) {
  Problem of_file = from_file(plate());
  const auto elements = std::get<Cover>(of_file.geometry).elements.size();
  of_file.covers->mesh.refined = {{{0.5, 0.5}, 1}};
  EXPECT_EQ(scene_of(of_file).model.elements.size(), elements);
  of_file.covers->mesh.refined = {{{0.5, 0.5}, 0.01}};
  const std::shared_ptr<const Continuum> finer = scene_of(of_file).model.continuum;
  EXPECT_GT(finer->manifold.elements.size(), elements + 20);
  EXPECT_NEAR(area_of(finer->manifold), 2, 1e-12);
}

TEST(RefinedCoverFile, what_it_cannot_have_is_refused) {
  Problem of_file = from_file(plate());
  of_file.covers->mesh.side = 0.1;
  EXPECT_NE(fault_of(of_file).find("found another mesh"), std::string::npos) << fault_of(of_file);
  Problem without = plate();
  without.covers->mesh.side = 0;
  without.covers->mesh.tip_side = 0.1;
  EXPECT_NE(fault_of(without).find("expected half_rows or side of the mesh"), std::string::npos) << fault_of(without);
}

}  // namespace keyblock::refined_cover_file_test
