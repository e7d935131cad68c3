// Statics of a roof wedge that the initial stress of the rock clamps between fixed blocks. Theory by hand: the stress s
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
  rock.initial_stress = {-kStress * c * c, -kStress * s * s, -kStress * c * s};
  problem.analysis->joint_materials[0].friction_angle_deg = wedge.friction;
  return problem;
}

struct Held {
  RunOutcome outcome;
  double moment = 0;    ///< sum of H x over the corners of both sides
  double vertical = 0;  ///< force on the wedge
};

Held held(const Wedge& wedge) {
  const double angle = radians(wedge.turned_by);
  const Point down = turned(Point{0, -10}, angle);
  const Prepared prepared =
      prepare(scene(wedge), "standard",
              {{"motion", "static"}, {"gravity.x", std::to_string(down.x)}, {"gravity.y", std::to_string(down.y)}});
  Held found;
  Observer observer;
  observer.on_state = [&](const Stepper& stepper) {
    found.moment = found.vertical = 0;
    for (const ContactFrame& contact : stepper.contacts()) {
      const Point force = turned((contact.element == 2 ? 1 : -1) * contact.force(), -angle);
      found.moment += std::abs(force.x * turned(contact.position, -angle).x);
      found.vertical += force.y;
    }
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

TEST(ClampedWedge, falls_if_its_sides_are_steeper_than_friction) {
  EXPECT_NE(held({20, 0, 19, 0}).outcome.end, RunEnd::finished);
  EXPECT_NE(held({20, 0.5, 19, 0}).outcome.end, RunEnd::finished);
}

}  // namespace keyblock::clamped_wedge_test
