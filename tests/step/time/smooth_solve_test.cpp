// The motion of a step without impacts beside statics and dynamics of one block: in flight, at rest, sliding, in a
// wedge, on a support that accelerates.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/time/smooth_solve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "step/scene/touch_search.hpp"
#include "step/time/ledger.hpp"
#include "tests/support/standard_scenes.hpp"

namespace keyblock::smooth_solve_test {
namespace {

using support::plain_analysis;
using support::radians;
using support::rectangle;

constexpr double kStep = 1e-3, kGravity = 9.81, kMass = 2500, kWeight = kMass * kGravity;
constexpr double kForce = 1e-8 * kWeight;  // to which forces are compared
constexpr double kWay = 1e-12;             // and displacements [m]
constexpr ElementIndex kBlock{1};

/// A scene whose block 1 is a free, rigid square metre; contacts without springs.
struct Step {
  Scene drawn;
  StandardScene scene;
  Motion start;
  Touches touches;
  StepRule rule;

  Step(Blocks blocks, double friction_deg, const std::vector<TimeCurve>& motions = {})
      : drawn(drawn_of(std::move(blocks), friction_deg, motions)),
        scene(standard_scene(drawn.model, drawn.settings)),
        start(start_motion(scene)),
        rule(step_rule(scene.settings.standard, kStep)) {
    touches = touches_of(scene, start, scales_of(scene, loads(), start.q, start.v), kStep);
  }

  static Scene drawn_of(Blocks blocks, double friction_deg, const std::vector<TimeCurve>& motions) {
    Analysis analysis = plain_analysis(kStep, 1);
    analysis.joint_materials[0].friction_angle_deg = friction_deg;
    analysis.fixed_point_motions = motions;
    Settings settings = support::standard_settings(analysis);
    settings.basis = BlockBasis::rigid;
    settings.standard.enforcement = Enforcement::lagrange;
    return support::standard_scene_of(blocks, analysis, settings);
  }

  UnknownsTable loads() const { return loads_at(scene, start.q, 0); }

  SmoothMotion solve(const SmoothMotion* before = nullptr) const {
    return smooth_solve(scene, start, loads(), touches, {1e-10 * kWeight, 1e-6 * kWeight}, 0, kStep, rule, before);
  }

  /// Normal and tangential forces of the contacts of the block with this element, summed.
  Eigen::Vector2d forces_with(ElementIndex other, const SmoothMotion& made) const {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (std::size_t i = 0; i < touches.size(); ++i) {
      const ElementIndex a = scene.model.vertices[touches[i].vertex].element;
      const ElementIndex b = scene.model.vertices[touches[i].start].element;
      if (a == other || b == other) sum += made.forces.segment<2>(static_cast<Eigen::Index>(2 * i));
    }
    return sum;
  }
};

void expect_near(const Unknowns& found, const Eigen::Vector3d& expected, double tolerance) {
  ASSERT_EQ(found.size(), 3);
  EXPECT_LT((found - expected).norm(), tolerance) << found.transpose() << " for " << expected.transpose();
}

Blocks on_floor(double gap) {
  Blocks blocks;
  blocks.blocks = {rectangle({-2, -1}, {3, 0}), rectangle({0, gap}, {1, 1 + gap})};
  blocks.fixed_points = {{{-1, -0.5}, 0, {}}, {{2, -0.5}, 0, {}}};
  return blocks;
}

}  // namespace

// Weighted sums of both ends give the parabola exactly.
TEST(SmoothSolve, a_block_in_flight_follows_its_parabola) {
  Step step(on_floor(50), 0);
  step.touches.clear();
  step.start.v[kBlock] << 3, 4, -0.2;
  const SmoothMotion made = step.solve();
  EXPECT_TRUE(made.converged);
  EXPECT_EQ(made.forces.size(), 0);
  expect_near(made.q[kBlock], {3 * kStep, 4 * kStep - kGravity * kStep * kStep / 2, -0.2 * kStep}, kWay);
  expect_near(made.v[kBlock], {3, 4 - kGravity * kStep, -0.2}, kWay);
}

TEST(SmoothSolve, a_block_at_rest_on_a_slope_stays_where_friction_bears_it) {
  for (const double slope : {0.0, 10.0, 30.0, 44.0}) {
    const Step step(support::block_on_slope(radians(slope)), slope + 0.5);
    ASSERT_GE(step.touches.size(), 2);
    const SmoothMotion made = step.solve();
    EXPECT_TRUE(made.converged);
    EXPECT_EQ(made.end, RoundsEnd::balanced);
    expect_near(made.q[kBlock], Eigen::Vector3d::Zero(), kWay);
    expect_near(made.v[kBlock], Eigen::Vector3d::Zero(), kWay / kStep);
    const Eigen::Vector2d forces = step.forces_with(kBlock, made);
    EXPECT_NEAR(forces[0], kWeight * std::cos(radians(slope)), kForce) << slope;
    EXPECT_NEAR(std::abs(forces[1]), kWeight * std::sin(radians(slope)), kForce) << slope;
  }
}

// a = g (sin α - μ cos α) down the slope, and half of it from the mean of both ends: s = a dt²/2.
TEST(SmoothSolve, a_block_slides_down_a_slope_by_gravity_less_friction) {
  for (const double friction : {0.0, 10.0, 29.0}) {
    const Step step(support::block_on_slope(radians(30)), friction);
    const SmoothMotion made = step.solve();
    EXPECT_TRUE(made.converged);
    const double mu = std::tan(radians(friction)), slope = radians(30);
    const double along = kGravity * (std::sin(slope) - mu * std::cos(slope));
    const Eigen::Vector3d down(std::cos(slope), -std::sin(slope), 0);
    expect_near(made.v[kBlock], along * kStep * down, 1e-10);
    expect_near(made.q[kBlock], along * kStep * kStep / 2 * down, kWay);
    const Eigen::Vector2d forces = step.forces_with(kBlock, made);
    EXPECT_NEAR(std::abs(forces[1]), mu * forces[0], kForce) << friction;
  }
}

// With the velocity it has, against which friction acts: a = -μ g.
TEST(SmoothSolve, friction_slows_a_block_that_slides_on_a_level_floor) {
  for (const double speed : {2.0, -2.0}) {
    Step step(on_floor(0), 20);
    step.start.v[kBlock] << speed, 0, 0;
    const SmoothMotion made = step.solve();
    EXPECT_TRUE(made.converged);
    const double slower = speed - std::copysign(std::tan(radians(20)) * kGravity * kStep, speed);
    expect_near(made.v[kBlock], {slower, 0, 0}, 1e-10);
    expect_near(made.q[kBlock], {(speed + slower) / 2 * kStep, 0, 0}, kWay);
  }
}

// A square in a right-angled groove, its lower edge at φ to the horizontal. Without friction each face carries the
// component of the weight across it, in any distribution over its corners.
TEST(SmoothSolve, both_faces_of_a_wedge_bear_their_component_of_the_weight) {
  for (const double turn : {0.2, 0.6, 1.2}) {
    Blocks blocks;
    blocks.blocks = {support::turned_rectangle({0, -1}, {2, 0}, turn), support::turned_rectangle({0, 0}, {1, 1}, turn),
                     support::turned_rectangle({-1, 0}, {0, 2}, turn)};
    const auto hold = [&](int block, Point a, Point b) {
      for (const Point at : {a, b}) blocks.fixed_points.push_back({turned(at, turn), block, {}});
    };
    hold(0, {0.3, -0.5}, {1.7, -0.5});
    hold(2, {-0.5, 0.3}, {-0.5, 1.7});
    const Step step(blocks, 0);
    const SmoothMotion made = step.solve();
    EXPECT_TRUE(made.converged) << turn;
    expect_near(made.q[kBlock], Eigen::Vector3d::Zero(), kWay);
    EXPECT_NEAR(step.forces_with(ElementIndex{0}, made)[0], kWeight * std::cos(turn), kForce) << turn;
    EXPECT_NEAR(step.forces_with(ElementIndex{2}, made)[0], kWeight * std::sin(turn), kForce) << turn;
  }
}

// The law is one of the gap at the end: a block that would fall 4.9 µm from 3 µm ends on the floor, one 6 µm above it
// falls freely.
TEST(SmoothSolve, a_gap_closes_at_the_end_of_the_step_and_no_farther) {
  const double fall = kGravity * kStep * kStep / 2;
  const SmoothMotion lands = Step(on_floor(3e-6), 30).solve();
  EXPECT_TRUE(lands.converged);
  expect_near(lands.q[kBlock], {0, -3e-6, 0}, kWay);
  const Step from_above(on_floor(6e-6), 30);
  const SmoothMotion falls = from_above.solve();
  ASSERT_GE(from_above.touches.size(), 2);
  expect_near(falls.q[kBlock], {0, -fall, 0}, kWay);
  EXPECT_EQ(falls.forces.cwiseAbs().maxCoeff(), 0);
}

// The floor goes up by a dt²/2 in the step, from rest: it presses with m (g + a).
TEST(SmoothSolve, a_floor_that_accelerates_presses_by_as_much_more) {
  for (const double up : {-4.0, 0.0, 20.0}) {
    const TimeCurve rises{{0, kStep}, {{0, 0}, {0, up * kStep * kStep / 2}}, {}};
    const Step step(on_floor(0), 30, {rises, rises});
    ASSERT_EQ(step.scene.held.size(), 2);
    const SmoothMotion made = step.solve();
    EXPECT_TRUE(made.converged) << up;
    EXPECT_NEAR(step.forces_with(kBlock, made)[0], kMass * (kGravity + up), 1e-6 * kWeight) << up;
    expect_near(made.q[kBlock], {0, up * kStep * kStep / 2, 0}, kWay);
    expect_near(made.v[kBlock], {0, up * kStep, 0}, 1e-9);
    // The points carry the floor, of five square metres, and the block, and accelerate both.
    const Eigen::VectorXd& points = made.constraints.point_forces;
    EXPECT_NEAR(points[1] + points[3], 6 * kMass * (kGravity + up), 1e-6 * kWeight) << up;
    EXPECT_NEAR(points[0] + points[2], 0, 1e-6 * kWeight) << up;
  }
}

// A square that rotates about a fixed point has only the velocity of that rotation. Rows at the middle of the step keep
// its energy to third order in the angle of the step; rows at either end would change it to second order.
TEST(SmoothSolve, a_block_that_turns_about_a_held_point_keeps_its_energy) {
  const auto gained = [](double angle) {
    Blocks blocks = on_floor(0);
    blocks.blocks[1] = rectangle({0, 5}, {1, 6});
    blocks.fixed_points.push_back({{0, 5}, 1, {}});
    Step step(blocks, 0);
    step.touches.clear();
    step.start.v[kBlock] << -0.5 * angle / kStep, 0.5 * angle / kStep, angle / kStep;
    UnknownsTable loads = step.loads();
    for (ElementIndex e : indices(loads)) loads[e].setZero();
    const SmoothMotion made =
        smooth_solve(step.scene, step.start, loads, {}, {1e-10 * kWeight, 1e-6 * kWeight}, 0, kStep, step.rule);
    EXPECT_TRUE(made.converged);
    EXPECT_NEAR(made.q[kBlock][2], angle, 0.01 * angle);
    return kinetic_energy(step.scene, made.v) / kinetic_energy(step.scene, step.start.v) - 1;
  };
  const double once = gained(0.02), twice = gained(0.04);
  EXPECT_LT(std::abs(once), 0.02 * 0.02 * 0.02);
  EXPECT_LT(std::abs(twice), 0.04 * 0.04 * 0.04);
}

// Tried first, the forces of the same step need no search.
TEST(SmoothSolve, an_earlier_solution_of_the_step_is_found_again_with_less_work) {
  const Step step(support::block_on_slope(radians(30)), 20);
  const SmoothMotion first = step.solve();
  const SmoothMotion again = step.solve(&first);
  EXPECT_TRUE(again.converged);
  EXPECT_LT(again.solves, first.solves);
  expect_near(again.q[kBlock], first.q[kBlock], kWay);
  EXPECT_LT((again.forces - first.forces).cwiseAbs().maxCoeff(), kForce);
}

TEST(SmoothSolve, a_residual_above_the_goal_names_its_touch) {
  const Step step(support::block_on_slope(radians(30)), 35);
  const SmoothMotion made =
      smooth_solve(step.scene, step.start, step.loads(), step.touches, {0, 1e-6 * kWeight}, 0, kStep, step.rule);
  EXPECT_TRUE(made.converged);
  EXPECT_LE(made.residual, 1e-6 * kWeight);
  EXPECT_EQ(made.worst.has_value(), made.residual > 0);
  if (made.worst) {
    EXPECT_LT(*made.worst, step.touches.size());
  }
  EXPECT_FALSE(step.solve().worst);
}

// A pseudo step of statics passes through states that rock never takes: it names bonds beyond their strength.
TEST(SmoothSolve, a_bond_beyond_its_strength_breaks_in_time_and_is_named_on_the_way_to_rest) {
  Step step(support::block_on_slope(radians(30)), 0);
  step.scene.model.joint_materials[0].cohesion = 0.49 * kWeight;  // W sin 30 along a face of 1 m needs 0.5 W
  step.start.bonds = bonds_at(step.scene, step.start, scales_of(step.scene, step.loads(), step.start.q, step.start.v));
  ASSERT_EQ(step.start.bonds.size(), 2U);
  const SmoothMotion in_time = step.solve();
  EXPECT_TRUE(in_time.bonds.empty());
  EXPECT_TRUE(in_time.overloaded.empty());
  step.rule = resting_rule(1);
  const SmoothMotion on_the_way = step.solve();
  EXPECT_EQ(on_the_way.bonds.size(), 2U);
  EXPECT_EQ(on_the_way.overloaded.size(), 2U);
  EXPECT_NEAR(std::abs(step.forces_with(kBlock, on_the_way)[1]), kWeight / 2, kForce);
  step.scene.model.joint_materials[0].cohesion = 0.51 * kWeight;
  EXPECT_TRUE(step.solve().overloaded.empty());
}

}  // namespace keyblock::smooth_solve_test
