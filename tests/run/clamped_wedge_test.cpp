// Roof wedges that fixed blocks clamp, by initial stress or by a motion of those blocks. Theory by hand: the stress s
// of a symmetric wedge of area A needs the sum of H x = s A / 2 over the corners of each side.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <variant>

#include "run/prepare.hpp"
#include "run/run.hpp"
#include "tests/support/standard_scenes.hpp"

namespace keyblock::clamped_wedge_test {
namespace {

using support::plain_analysis;
using support::radians;

constexpr double kHeight = 2;
constexpr double kStress = 1e6;

struct Wedge {
  double half_angle = 20;  ///< of its sides to the vertical, in degrees
  double top = 0;          ///< half its width at the top
  double friction = 45;
  double turned_by = 0;  ///< degrees, with gravity and stress
  double stress = kStress;
};

Problem scene(const Wedge& wedge) {
  const double foot = wedge.top + kHeight * std::tan(radians(wedge.half_angle));
  const auto block = [&](int material, std::vector<Point> corners) {
    BlockPolygon polygon{material, {}, {}};
    for (const Point p : corners) polygon.outer.push_back({turned(p, radians(wedge.turned_by)), 0});
    return polygon;
  };
  std::vector<Point> middle{{-foot, 0}, {foot, 0}, {wedge.top, kHeight}};
  if (wedge.top > 0) middle.push_back({-wedge.top, kHeight});
  Blocks blocks;
  blocks.blocks = {block(0, {{foot, 0}, {foot + 3, 0}, {foot + 3, kHeight}, {wedge.top, kHeight}}),
                   block(0, {{-foot - 3, 0}, {-foot, 0}, {-wedge.top, kHeight}, {-foot - 3, kHeight}}),
                   block(0, middle)};
  for (const int side : {1, -1})
    for (const Point p : {Point{foot + 1, 0.3}, Point{foot + 2.5, 1.7}})
      blocks.fixed_points.push_back({turned(Point{side * p.x, p.y}, radians(wedge.turned_by)), side > 0 ? 0 : 1, {}});
  Problem problem;
  problem.geometry = blocks;
  problem.analysis = plain_analysis(1e-3, 1);
  const double c = std::cos(radians(wedge.turned_by)), s = std::sin(radians(wedge.turned_by));
  BlockMaterial& rock = problem.analysis->block_materials[0];
  rock.youngs_modulus = 2e10;
  rock.poissons_ratio = 0;
  rock.initial_stress = {-wedge.stress * c * c, -wedge.stress * s * s, -wedge.stress * c * s};
  problem.analysis->joint_materials[0].friction_angle_deg = wedge.friction;
  return problem;
}

struct Held {
  RunOutcome outcome;
  double moment = 0;              ///< sum of H x over the corners of both sides
  double vertical = 0;            ///< force on the wedge
  std::vector<double> pressures;  ///< normal forces
};

Held held(const Wedge& wedge, const std::string& motion = "static", int steps = 1,
          const std::string& basis = "affine") {
  const double angle = radians(wedge.turned_by);
  const Point down = turned(Point{0, -10}, angle);
  Problem problem = scene(wedge);
  problem.analysis->step_count = steps;
  const Prepared prepared = prepare(problem, "standard",
                                    {{"motion", motion},
                                     {"basis", basis},
                                     {"gravity.x", std::to_string(down.x)},
                                     {"gravity.y", std::to_string(down.y)}});
  Held found;
  Observer observer;
  observer.on_state = [&](const Stepper& stepper) {
    found.moment = found.vertical = 0;
    found.pressures.clear();
    for (const ContactFrame& contact : stepper.contacts()) {
      const Point force = turned((contact.element == 2 ? 1 : -1) * contact.force(), -angle);
      found.moment += std::abs(force.x * turned(contact.position, -angle).x);
      found.vertical += force.y;
      if (contact.normal_force > 0) found.pressures.push_back(contact.normal_force);
    }
  };
  found.outcome = run(prepared.scene, 1, observer);
  return found;
}

// Fixed blocks move by kWay each towards a wedge without stress; then a load grows in steps to its weight.
struct Driven {
  double sunk = 0;    ///< foot of the wedge
  double normal = 0;  ///< force of one side
  double shear = 0;
  RunOutcome outcome;
};

constexpr double kWay = 1e-4;
constexpr double kStiffness = 1e9;  ///< of a contact across its face; 0.4 of that along it

Driven driven(double friction, int loads, double far, double weight) {
  Problem problem = scene({20, 0, friction, 0});
  Blocks& blocks = std::get<Blocks>(problem.geometry);
  Analysis& analysis = *problem.analysis;
  analysis.time_step = 1;
  analysis.step_count = 2 + loads;
  analysis.block_materials[0].youngs_modulus = 1e13;
  analysis.block_materials[0].initial_stress = {};
  for (const BlockPoint& point : blocks.fixed_points) {
    const Point moved{point.position.x > 0 ? -kWay : kWay, 0};
    analysis.fixed_point_motions.push_back({{0, 1, 1000}, {{0, 0}, moved, moved}, {}});
  }
  blocks.loading_points.push_back({{0, kHeight / 3}, 2, {}});
  const Point full{0, -weight};
  analysis.point_loads.push_back({{0, 2, 2.0 + loads, 1000}, {{0, 0}, {0, 0}, full, full}, {}});
  const Point offset{far, far};
  for (BlockPolygon& block : blocks.blocks)
    for (auto& corner : block.outer) corner.position = corner.position + offset;
  for (auto* points : {&blocks.fixed_points, &blocks.loading_points})
    for (BlockPoint& point : *points) point.position = point.position + offset;
  const Prepared prepared = prepare(problem, "standard",
                                    {{"motion", "static"},
                                     {"gravity.x", "0"},
                                     {"gravity.y", "0"},
                                     {"enforcement", "penalty"},
                                     {"contact_penalty", std::to_string(kStiffness)},
                                     {"normal_to_shear_stiffness", "2.5"}});
  Driven found;
  Observer observer;
  observer.on_state = [&](const Stepper& stepper) {
    found.normal = found.shear = 0;
    for (const ContactFrame& contact : stepper.contacts()) {
      const bool is_right = (contact.element == 2 ? -1 : 1) * contact.normal.x > 0;
      if (!is_right) continue;
      found.normal += contact.normal_force;
      found.shear += std::abs(contact.shear_force);
    }
    found.sunk = far + kHeight / 3 - stepper.state().elements[ElementIndex(2)].centroid.y;
  };
  found.outcome = run(prepared.scene, 1, observer);
  return found;
}

}  // namespace

// The first iteration let the stress push the blocks apart and the wedge fall through the gap: it "accelerated" at any
// friction.
TEST(ClampedWedge, stands_by_the_friction_that_its_stress_wakes) {
  for (const double top : {0.0, 0.5})
    for (const double half_angle : {5.0, 20.0})
      for (const double turned_by : {0.0, 37.0}) {
        const Held found = held({half_angle, top, 45, turned_by});
        ASSERT_EQ(found.outcome.end, RunEnd::finished) << top << " " << half_angle << ": " << found.outcome.reason;
        const double foot = top + kHeight * std::tan(radians(half_angle));
        EXPECT_NEAR(found.moment / (kStress * kHeight * (top + foot)), 1, 1e-3) << top << " " << half_angle;
        EXPECT_NEAR(found.vertical / (10 * 2500 * kHeight * (top + foot)), 1, 1e-3) << top << " " << half_angle;
      }
}

// Equilibrium leaves the share of foot and apex open: the foot bore all, half of the stress of a triangle.
TEST(ClampedWedge, bears_its_stress_at_both_ends_of_a_face) {
  for (const char* motion : {"dynamic", "static"})
    for (const double top : {0.0, 0.5}) {
      const Held found = held({20, top, 45, 0}, motion, 20);
      ASSERT_EQ(found.outcome.end, RunEnd::finished) << motion << " " << top;
      ASSERT_EQ(found.pressures.size(), 4U) << motion << " " << top;
      const double exact = kStress * std::cos(radians(20)) * kHeight / 2;
      for (const double pressure : found.pressures) EXPECT_NEAR(pressure / exact, 1, 0.015) << motion << " " << top;
    }
}

// Friction of 41.4 degrees is mobilised by hand. In time the wedge fell: its faces opened within a step, before the
// stress that clamps it had relaxed.
TEST(ClampedWedge, stands_under_little_stress_in_time_as_in_statics) {
  for (const char* motion : {"dynamic", "static"}) {
    const Held found = held({20, 0, 45, 0, 2e4}, motion, 50);
    ASSERT_EQ(found.outcome.end, RunEnd::finished) << motion;
    const double weight = 10 * 2500 * kHeight * kHeight * std::tan(radians(20));
    EXPECT_NEAR(found.vertical / weight, 1, 1e-3) << motion;
  }
}

// Rigid blocks dropped their stress without a word and fell.
TEST(ClampedWedge, stands_if_its_rock_is_rigid) {
  for (const char* motion : {"dynamic", "static"}) {
    const Held found = held({20, 0, 45, 0}, motion, 20, "rigid");
    ASSERT_EQ(found.outcome.end, RunEnd::finished) << motion << ": " << found.outcome.reason;
    const double weight = 10 * 2500 * kHeight * kHeight * std::tan(radians(20));
    EXPECT_NEAR(found.vertical / weight, 1, 1e-3) << motion;
  }
}

// Crawford and Bray (1983). A way u clamps a side with N0 = kn cos a u and S0 = ks sin a u. If the wedge then
// sinks by v, N = N0 - kn v sin a and S = S0 + ks v cos a. Balance: S cos a - N sin a = W / 2.
TEST(ClampedWedge, sticks_under_a_load_in_one_step_as_in_ten) {
  const double a = radians(20), kn = 2 * kStiffness, ks = 0.4 * kn;
  const double width = kHeight * std::tan(a), weight = 10 * 2500 * kHeight * width;
  const double denominator = ks * std::cos(a) * std::cos(a) + kn * std::sin(a) * std::sin(a);
  const double v = (weight / 2 + (kn - ks) * std::sin(a) * std::cos(a) * kWay) / denominator;
  const double normal = kn * (std::cos(a) * kWay - std::sin(a) * v);
  const double shear = ks * (std::sin(a) * kWay + std::cos(a) * v);
  for (const double far : {0.0, 1e5})
    for (const double friction : {28.0, 45.0})
      for (const int loads : {1, 10}) {
        const Driven found = driven(friction, loads, far, weight);
        ASSERT_EQ(found.outcome.end, RunEnd::finished) << friction << " " << loads << ": " << found.outcome.reason;
        EXPECT_NEAR(found.sunk / v, 1, 0.01) << friction << " " << loads << " " << far;
        EXPECT_NEAR(found.normal / normal, 1, 0.01) << friction << " " << loads << " " << far;
        EXPECT_NEAR(found.shear / shear, 1, 0.01) << friction << " " << loads << " " << far;
      }
  ASSERT_LT(std::atan(shear / normal), radians(28));
}

TEST(ClampedWedge, falls_if_its_sides_are_steeper_than_friction) {
  EXPECT_NE(held({20, 0, 19, 0}).outcome.end, RunEnd::finished);
  EXPECT_NE(held({20, 0.5, 19, 0}).outcome.end, RunEnd::finished);
}

}  // namespace keyblock::clamped_wedge_test
