// NMM bodies whose load steps are linear solutions: supports and loads arrive, forces balance, an excavation begins a
// scene, and an unsolvable case is named.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/bodies/linear_case.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "run/cover_settings.hpp"
#include "run/prepare.hpp"
#include "run/run.hpp"

namespace keyblock::linear_case_test {
namespace {

BlockPolygon block_of(const std::vector<Point>& corners, int material = 0) {
  BlockPolygon block;
  block.material = material;
  for (const Point p : corners) block.outer.push_back({p, 0});
  return block;
}

const std::vector<Point> kSquare{{0, 0}, {2, 0}, {2, 2}, {0, 2}};

/// A square of 2 × 2, E 1000, ν 0.25, weight 3 per area, on its lower edge, its left one a line of symmetry.
Problem square() {
  Problem problem;
  Blocks blocks;
  blocks.blocks = {block_of(kSquare)};
  blocks.measured_points = {{{1, 2}, 0, {}}, {{1, 1}, 0, {}}};
  problem.geometry = blocks;
  Analysis analysis;
  analysis.step_count = 1;
  analysis.time_step = 1;
  analysis.allowed_displacement_ratio = 0.1;
  BlockMaterial material;
  material.density = 1;
  material.unit_weight = 3;
  material.youngs_modulus = 1000;
  material.poissons_ratio = 0.25;
  analysis.block_materials = {material};
  analysis.joint_materials = {{}};
  problem.analysis = analysis;
  CoverPlan& covers = problem.covers.emplace();
  covers.mesh.side = 0.6;
  covers.mesh.angle_deg = 10;
  covers.displacements = {{{{0, 0}, {2, 0}}, Held::y, {}, {}, {}, {}},
                          {{{0, 0}, {0, 2}}, Held::normal, {}, {}, {}, {}}};
  return problem;
}

/// All reports of a run.
struct Solved {
  std::vector<Frame> frames;  ///< that of the initial state included
  std::vector<StepReport> steps;
  RunOutcome outcome;

  const Frame& last() const { return frames.back(); }
};

Solved solved(const Problem& problem) {
  const Prepared prepared = prepare(problem, "standard", {});
  EXPECT_TRUE(prepared.scene.is_untouched);
  Solved told;
  Observer observer;
  observer.on_frame = [&](const Frame& frame) { told.frames.push_back(frame); };
  observer.on_step = [&](const StepReport& report) { told.steps.push_back(report); };
  told.outcome = run(prepared.scene, 1, observer);
  return told;
}

/// Returns the reason why a case cannot be prepared, or why its run failed.
std::string fault_of(const Problem& problem) {
  try {
    return solved(problem).outcome.reason;
  } catch (const std::exception& error) {
    return error.what();
  }
}

Resultant sum_of(const ForceBalance& balance) {
  Resultant sum = balance.loads;
  sum.add(balance.springs);
  for (const Resultant& support : balance.supports) sum.add(support);
  return sum;
}

/// A quarter of a circle, ends on the axes.
std::vector<Point> quarter(double radius) {
  std::vector<Point> points;
  constexpr int kChords = 64;
  for (int i = 0; i <= kChords; ++i) {
    const double angle = std::numbers::pi / 2 * i / kChords;
    points.push_back({i == kChords ? 0 : radius * std::cos(angle), radius * std::sin(angle)});
  }
  return points;
}

/// A quarter of a disc under -1 all round; load step 2 of 3 excavates the inner half; measured on its edge.
Problem dug_disc() {
  Problem problem = square();
  std::vector<Point> disc = quarter(2);
  disc.insert(disc.begin(), {0, 0});
  std::vector<Point> hole = quarter(1);
  hole.insert(hole.begin(), {0, 0});
  Blocks blocks;
  blocks.blocks = {block_of(disc)};
  blocks.measured_points = {{hole[33], 0, {}}};
  problem.geometry = blocks;
  Analysis& analysis = *problem.analysis;
  analysis.plane_strain = true;
  analysis.step_count = 3;
  analysis.block_materials[0].unit_weight = 0;
  CoverPlan& covers = *problem.covers;
  covers.mesh.side = 0.125;
  covers.displacements = {{{{0, 0}, {2, 0}}, Held::normal, {}, {}, {}, {}},
                          {{{0, 0}, {0, 2}}, Held::normal, {}, {}, {}, {}}};
  covers.tractions = {{quarter(2), {}, {}, {"1", {}}, {}}};
  covers.initial_stress = {{"-1", {}}, {"-1", {}}, {"0", {}}};
  covers.excavations = {{2, hole, {}}};
  return problem;
}

}  // namespace

// A column free to widen carries 3 (2 - y); its field is quadratic: v = -3/1000 (2y - y²/2) + 3 · 0.25/2000 x², which
// is prescribed on its base.
TEST(LinearCase, a_column_carries_its_weight_and_all_forces_balance) {
  for (const char* functions : {"derived", "linear", "quadratic"}) {
    Problem problem = square();
    set(*problem.covers, "functions", functions);
    problem.covers->displacements[0].y.text = "3*0.25/2000*x^2";
    const Solved column = solved(problem);
    ASSERT_EQ(column.last().measured_points.size(), 2U);
    EXPECT_NEAR(column.last().measured_points[1].stress.yy, -3, 1e-8) << functions;
    EXPECT_NEAR(column.last().measured_points[0].displacement.y, -0.006 + 0.000375, 1e-13) << functions;
    ASSERT_TRUE(column.outcome.forces);
    const ForceBalance& balance = *column.outcome.forces;
    EXPECT_NEAR(balance.loads.force.y, -12, 1e-10);
    EXPECT_NEAR(balance.supports[0].force.y, 12, 1e-9);
    EXPECT_NEAR(balance.supports[1].force.x, 0, 1e-9);
    EXPECT_LT(length(sum_of(balance).force), 1e-9) << functions;
    EXPECT_LT(std::abs(sum_of(balance).moment), 1e-9) << functions;
    EXPECT_LT(balance.unbalanced(), 1e-10);
    EXPECT_LT(column.steps[0].residual, 1e-10);
  }
}

TEST(LinearCase, an_initial_stress_in_balance_with_the_loads_moves_nothing) {
  Problem problem = square();
  problem.covers->displacements[0].held = Held::both;
  problem.covers->initial_stress = {{"-5", {}}, {"-3*(2 - y)", {}}, {"0", {}}};
  problem.covers->tractions = {{{{2, 0}, {2, 2}}, {}, {}, {"5", {}}, {}}};
  const Frame last = solved(problem).last();
  EXPECT_LT(length(last.measured_points[0].displacement), 1e-14);
  EXPECT_NEAR(last.measured_points[1].stress.yy, -3, 1e-11);
  EXPECT_NEAR(last.measured_points[1].stress.xx, -5, 1e-11);
  // That of the materials, linear in y, does the same.
  Problem other = square();
  other.covers->displacements[0].held = Held::both;
  other.analysis->block_materials[0].initial_stress = {0, -6, 0};
  other.analysis->block_materials[0].stress_gradient = {0, 3, 0};
  EXPECT_LT(length(solved(other).last().measured_points[0].displacement), 1e-14);
}

// Lamé: in a disc under -1 all round, the edge of the excavated hole moves by (1 + ν)/E · a²/(b² - a²) ((1 - 2ν) a +
// b²/a) inwards.
TEST(LinearCase, what_is_dug_out_relaxes_its_edge) {
  std::vector<double> inward;
  const double edge = std::sqrt(0.5);
  const Solved disc = solved(dug_disc());
  for (const Frame& frame : disc.frames) {
    const Point u = frame.measured_points.at(0).displacement;
    inward.push_back(-edge * (u.x + u.y));
  }
  ASSERT_EQ(inward.size(), 4U);
  EXPECT_NEAR(inward[1], 0, 1e-14);
  const double theory = 1.25 / 1000 / 3 * (0.5 + 4);
  EXPECT_NEAR(inward[2], theory, 2e-3 * theory);
  EXPECT_EQ(inward[3], inward[2]);
  EXPECT_LT(disc.frames[2].elements.size(), disc.frames[1].elements.size());
  ASSERT_EQ(disc.outcome.scenes.size(), 2U);
  for (const SceneReport& scene : disc.outcome.scenes) {
    ASSERT_TRUE(scene.forces);
    EXPECT_LT(length(sum_of(*scene.forces).force), 1e-10);
  }
  // The second scene is solved once.
  EXPECT_EQ(disc.steps[1].passes, 1);
  EXPECT_EQ(disc.steps[2].passes, 0);
}

TEST(LinearCase, what_a_load_step_leaves_is_known_by_the_number_of_the_element_it_was) {
  const Solved disc = solved(dug_disc());
  const ElementsByNumber before(disc.frames[0]);
  const Frame& dug = disc.frames[2];
  for (std::size_t e = 0; e < dug.elements.size(); ++e) {
    const ElementFrame* was = before.find(origin_of(dug, e));
    ASSERT_NE(was, nullptr);
    const Point start = dug.elements[e].centroid - dug.elements[e].displacement;
    EXPECT_LE(distance(start, was->centroid), 0.1) << "sides of 0.125";
    EXPECT_LE(dug.elements[e].mass, was->mass * (1 + 1e-9));
  }
}

TEST(LinearCase, a_body_that_can_move_is_named_with_its_motion) {
  Problem problem = square();
  problem.covers->displacements.pop_back();
  EXPECT_EQ(fault_of(problem), "load step 1: body 1, about (1, 1), can move along (1, 0): it has no support");
  problem.covers->displacements.clear();
  EXPECT_NE(fault_of(problem).find("can move"), std::string::npos);
  Problem two = square();
  two.covers->contact = CoverContact::ignored;
  std::get<Blocks>(two.geometry).blocks.push_back(block_of({{3, 0}, {4, 0}, {4, 1}, {3, 1}}));
  EXPECT_NE(fault_of(two).find("body 2, about (3.5, 0.5), can move"), std::string::npos) << fault_of(two);
  EXPECT_EQ(solved(two).outcome.end, RunEnd::failed);
  EXPECT_EQ(solved(two).frames.size(), 1U) << "the start alone";
}

// Fixed along its lower side; a crack from side to side leaves the upper part without support. One that ends inside
// does not.
TEST(LinearCase, a_crack_that_cuts_a_body_through_is_named_with_what_it_cuts_off) {
  Problem problem = square();
  problem.covers->contact = CoverContact::ignored;
  problem.covers->displacements = {problem.covers->displacements.front()};
  problem.covers->displacements.front().along = {{0, 0}, {2, 0}};
  problem.covers->displacements.front().held = Held::both;
  problem.covers->cracks = {{{{0, 1}, {2, 1.5}}, {}, 0}};
  EXPECT_EQ(
      fault_of(problem),
      "load step 1: body 1, about (1, 1.5), can move along (1, 0): a crack or joint from (0, 1) to (2, 1.5) cuts it "
      "off from its body, and it has no support; support this part too, let its faces touch (contact=felt), or end "
      "the crack inside");
  problem.covers->cracks.front().along = {{0, 1}, {1.5, 1.375}};
  EXPECT_EQ(fault_of(problem), "");
}

TEST(LinearCase, what_cannot_be_is_named) {
  Problem problem = square();
  problem.covers->place = {"f", 2, 3};
  problem.analysis->place = {"f", 9, 1};
  problem.analysis->velocity_carry_over = 1;
  problem.covers->excavations = {{1, {{0, 0}, {1, 0}, {1, 1}}, {"f", 9, 1}}};
  EXPECT_EQ(fault_of(problem), "f:9:1: error: expected statics for excavations (velocity_carry_over 0), found 1");
  problem.covers->excavations.clear();
  problem.analysis->velocity_carry_over = 0;
  problem.covers->tractions = {{{{5, 5}, {6, 5}}, {}, {}, {}, {"f", 4, 7}}};
  EXPECT_EQ(fault_of(problem),
            "f:4:7: error: expected a chain on the boundary of NMM bodies, found none of it there: (5, 5), …");
  problem.covers->tractions.clear();
  problem.covers->forces = {{{9, 9}, {1, 0}, {"f", 5, 7}}};
  EXPECT_EQ(fault_of(problem), "f:5:7: error: expected a force in a body, found none at (9, 9)");
  problem.covers->forces.clear();
  problem.covers->body_force.x = {"1/(x - x)", {"f", 6, 1}};
  EXPECT_NE(fault_of(problem).find("f:6:1: error: expected a finite value of"), std::string::npos);
  problem.covers->body_force.x = {};
  problem.covers->excavations = {{2, kSquare, {"f", 7, 1}}};
  EXPECT_EQ(fault_of(problem), "f:7:1: error: expected a load step from 1 to 1, the step_count, found 2");
  EXPECT_THROW(prepare(square(), "legacy", {}), InputError);
}

TEST(LinearCase, a_force_and_a_spring_at_points_carry_each_other) {
  Problem problem = square();
  problem.analysis->block_materials[0].unit_weight = 0;
  problem.covers->displacements = {{{{0, 0}, {0, 2}}, Held::x, {}, {}, {}, {}}};
  problem.covers->springs = {{{1, 1}, {0, 2}, 50, {}}};
  problem.covers->forces = {{{1, 1}, {0, -2}, {}}};
  const Solved held = solved(problem);
  EXPECT_NEAR(held.last().measured_points[1].displacement.y, -0.04, 1e-12);  // -2 / 50
  ASSERT_TRUE(held.outcome.forces);
  EXPECT_NEAR(held.outcome.forces->springs.force.y, 2, 1e-11);
}

}  // namespace keyblock::linear_case_test
