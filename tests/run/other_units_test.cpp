// A case in other units is the same case: no number in the program has a scale of its own.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "run/prepare.hpp"
#include "run/run.hpp"
#include "tests/support/scenes.hpp"

namespace keyblock::other_units_test {
namespace {

/// Number of new units in an old one. Powers of two of even exponent, so that roots too are scaled without rounding.
struct NewUnits {
  double length = 1, mass = 1, time = 1;

  double acceleration() const { return length / (time * time); }
  double area_density() const { return mass / (length * length); }
  double stress() const { return mass / (time * time); }  // a force over a length: of a slice
};

/// Weak beds that fall towards a free right side, and joints across them: some blocks slide, some tip.
Problem jointed_bank(const NewUnits& units) {
  Drawing drawing;
  drawing.edge_node_ratio = 1e-3;
  drawing.place = {"bank", 0, 0};
  const auto scaled = [&](Point p) { return Point{p.x * units.length, p.y * units.length}; };
  const auto add = [&](Point from, Point to, int material) {
    drawing.joints.push_back({{scaled(from), scaled(to)}, material, {}});
  };
  const std::vector<Point> outline = {{0, 0}, {12, 0}, {12, 6.3}, {0, 9.1}};
  for (std::size_t i = 0; i < outline.size(); ++i) add(outline[i], outline[(i + 1) % outline.size()], 0);
  drawing.boundary_count = outline.size();
  for (const double left : {3.4, 5.2, 7.3}) add({0, left}, {12, left - 2.8}, 0);
  for (const double foot : {1.7, 4.1, 7.2, 9.3}) add({foot, 0}, {foot + 0.5, 9.1 - (foot + 0.5) * 2.8 / 12}, 1);
  drawing.fixed_lines = {{{scaled({0, 0.1}), scaled({12, 0.1})}, {}}};
  for (const Point p : {Point{11, 6}, Point{6, 4.4}, Point{1, 8}}) drawing.measured_points.push_back({scaled(p), {}});
  Problem problem;
  problem.geometry = drawing;
  Analysis analysis = support::plain_analysis(1.0 / 512 * units.time, 100);
  analysis.gravity = 9.81 * units.acceleration();
  analysis.block_materials[0].density *= units.area_density();
  analysis.block_materials[0].unit_weight *= units.area_density() * units.acceleration();
  analysis.block_materials[0].youngs_modulus *= units.stress();
  analysis.joint_materials.assign(2, JointMaterial{});
  analysis.joint_materials[0].friction_angle_deg = 9;
  analysis.joint_materials[1].friction_angle_deg = 25;
  analysis.joint_materials[1].cohesion = 2e3 * units.stress();
  problem.analysis = analysis;
  return problem;
}

std::vector<Point> ways(const NewUnits& units, const std::vector<Override>& overrides) {
  const Prepared prepared = prepare(jointed_bank(units), "standard", overrides);
  Frame first, last;
  Observer observer;
  observer.on_frame = [&](const Frame& frame) { (frame.step == 0 ? first : last) = frame; };
  EXPECT_EQ(run(prepared.scene, 1000, observer).end, RunEnd::finished);
  std::vector<Point> all;
  for (std::size_t i = 0; i < last.measured_points.size(); ++i) {
    const Point way = last.measured_points[i].position - first.measured_points[i].position;
    all.push_back({way.x / units.length, way.y / units.length});
  }
  return all;
}

}  // namespace

// An absolute tolerance anywhere would show; 1e-10 is a hundred-millionth of the displacement, beyond round-off. In
// units that round otherwise friction may share the load in other ways: that is the last digit of the input, not its
// scale.
TEST(OtherUnits, a_jointed_bank_moves_the_same_in_units_that_round_alike) {
  const std::vector<std::vector<Override>> choices = {
      {}, {{"start", "sudden"}}, {{"enforcement", "lagrange"}}, {{"impact", "springs"}}, {{"step_control", "error"}}};
  for (const std::vector<Override>& overrides : choices) {
    SCOPED_TRACE(overrides.empty() ? "presets" : overrides.front().second);
    const std::vector<Point> expected = ways({}, overrides);
    ASSERT_EQ(expected.size(), 3U);
    EXPECT_GT(expected[0].x, 0.01) << "it slides";
    for (const NewUnits& units : {NewUnits{1024, 1, 1}, NewUnits{1, 1.0 / 4096, 1}, NewUnits{1, 1, 256},
                                  NewUnits{1.0 / 1048576, 65536, 1.0 / 16}}) {
      const std::vector<Point> found = ways(units, overrides);
      for (std::size_t i = 0; i < expected.size(); ++i)
        EXPECT_LT(distance(found[i], expected[i]), 1e-10) << units.length << ' ' << units.mass << ' ' << units.time;
    }
  }
}

}  // namespace keyblock::other_units_test
