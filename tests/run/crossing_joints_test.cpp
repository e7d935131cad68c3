// Corners of opposite blocks meet at crossings of joints: a block that slides along one joint must not catch on the
// other.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "run/prepare.hpp"
#include "run/run.hpp"
#include "tests/cut/drawings.hpp"
#include "tests/support/scenes.hpp"

namespace keyblock::crossing_joints_test {
namespace {

constexpr double kGravity = 9.81, kBedding = 25, kCross = 35;

double rad(double degrees) {
  return degrees * std::numbers::pi / 180;
}

/// A bench with a fixed base: two bedding joints that fall to the right, and one across them that falls to the left and
/// comes out in the free left face.
Problem bench(double dt, int steps) {
  Drawing drawing;
  drawing.edge_node_ratio = 1e-3;
  drawing.place = {"bench", 0, 0};
  const auto add = [&](Point from, Point to, int material) { drawing.joints.push_back({{from, to}, material, {}}); };
  const std::vector<Point> outline = {{0, 0}, {10, 0}, {10, 4}, {7, 4}, {3, 10}, {0, 10}};
  for (std::size_t i = 0; i < outline.size(); ++i) add(outline[i], outline[(i + 1) % outline.size()], 0);
  const auto bedding = [](double x, double at_0) { return Point{x, at_0 - 7.0 / 12 * x}; };
  const double upper = 9 - 7.0 / 12, lower = 6 - 7.0 / 12;
  add({0, upper}, bedding((14.5 - upper) / (1.5 - 7.0 / 12), upper), 0);
  add(bedding((upper - 4) * 12 / 7, upper), bedding(10, upper), 0);
  add({0, lower}, bedding(lower * 12 / 7, lower), 0);
  const double low = 1 + 10.0 / 7, x = (14.5 - low) / (1.5 + 10.0 / 7);
  add({0, low}, {x, low + 10.0 / 7 * x}, 1);
  drawing.fixed_lines = {{{{0, 0}, {10, 0}}, {}}};
  drawing.measured_points = {{{1, 6.4}, {}}};
  Problem problem;
  problem.geometry = drawing;
  problem.analysis = support::plain_analysis(dt, steps);
  problem.analysis->joint_materials.assign(2, JointMaterial{});
  problem.analysis->joint_materials[0].friction_angle_deg = kBedding;
  problem.analysis->joint_materials[1].friction_angle_deg = kCross;
  return problem;
}

// The slab between the bedding joints has only a wedge below, which slides out of its way. It goes down the cross joint
// at least as fast as alone, because the bedding, at no more than its friction angle from vertical, transmits the
// weight above to it. Rigid blocks with sharp corners, exactly as drawn, go the same way with any step.
TEST(CrossingJoints, a_block_slides_down_one_joint_past_the_corner_at_the_crossing) {
  const double dip = std::atan(10.0 / 7), time = 0.2;
  const double alone = kGravity * (std::sin(dip) - std::cos(dip) * std::tan(rad(kCross))) * time * time / 2;
  const std::vector<Override> ideal = {{"basis", "rigid"}, {"enforcement", "lagrange"}, {"corner_rounding", "0"}};
  // A corner that comes to a crossing has contact with the edge beyond it once it has passed the rounding, by default 2
  // mm.
  const std::vector<Override> fine = {{"corner_rounding", "3e-5"}};
  double rigid = 0;
  for (const auto& [dt, settings] : {std::pair{4e-3, ideal}, {4e-3, fine}, {2e-3, fine}, {1e-3, fine}, {5e-4, fine}}) {
    const Prepared prepared = prepare(bench(dt, static_cast<int>(std::lround(time / dt))), "standard", settings);
    ASSERT_EQ(prepared.blocks.blocks.size(), 7U);
    Frame last;
    Observer observer;
    observer.on_frame = [&](const Frame& frame) { last = frame; };
    ASSERT_EQ(run(prepared.scene, 1, observer).end, RunEnd::finished) << dt;
    const double travel = distance(last.measured_points[0].position, {1, 6.4});
    EXPECT_GT(travel, 0.99 * alone) << dt;
    if (settings == ideal) rigid = travel;
    EXPECT_NEAR(travel, rigid, 0.01 * rigid) << dt;
  }
}

}  // namespace
}  // namespace keyblock::crossing_joints_test
