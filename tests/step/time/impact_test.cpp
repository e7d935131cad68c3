// Jumps of velocity beside the laws of impact: Newton's restitution, Coulomb's cone, momentum, energy, driven supports;
// and overlaps that are pushed out without velocity.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/time/impact.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <vector>

#include "step/scene/touch_search.hpp"
#include "step/time/ledger.hpp"
#include "tests/support/standard_scenes.hpp"

namespace keyblock::impact_test {
namespace {

using support::plain_analysis;
using support::rectangle;
using support::standard_scene_of;
using support::standard_settings;

constexpr double kRounding = 1e-12;
constexpr ElementIndex kFirst{0}, kSecond{1}, kThird{2};

/// Rigid blocks, block i of material i, as drawn, with all closed contacts.
struct Struck {
  Scene drawn;
  StandardScene scene;
  Motion motion;
  Touches touches;
  Flexibility flexibility;

  Struck(const Blocks& blocks, const std::vector<double>& densities, double restitution, double friction_deg = 0,
         const std::vector<TimeCurve>& motions = {})
      : drawn(drawn_of(blocks, densities, restitution, friction_deg, motions)),
        scene(standard_scene(drawn.model, drawn.settings)),
        motion(start_motion(scene)),
        flexibility{rigid_mass_inverses(scene.bodies())} {
    const Scales scales = scales_of(scene, loads_at(scene, motion.q, 0), motion.q, motion.v);
    touches = touches_of(scene, motion, scales, 1e-3);
    const auto vertices = vertices_at(scene.model, scene.reference, motion.q);
    std::erase_if(touches, [&](const Touch& touch) { return gap_of(touch, vertices) > 1e-9; });
  }

  static Scene drawn_of(Blocks blocks, const std::vector<double>& densities, double restitution, double friction_deg,
                        const std::vector<TimeCurve>& motions) {
    Analysis analysis = plain_analysis(1e-3, 1);
    analysis.joint_materials[0].friction_angle_deg = friction_deg;
    analysis.fixed_point_motions = motions;
    analysis.block_materials.resize(densities.size(), analysis.block_materials[0]);
    for (std::size_t i = 0; i < densities.size(); ++i) {
      analysis.block_materials[i].density = densities[i];
      blocks.blocks[i].material = static_cast<int>(i);
    }
    Settings settings = standard_settings(analysis);
    settings.basis = BlockBasis::rigid;
    settings.standard.restitution = restitution;
    return standard_scene_of(blocks, analysis, settings);
  }

  void move(ElementIndex e, double x, double y, double turn = 0) { motion.v[e] << x, y, turn; }

  /// All contacts begin `since` before the end of the step, in which they `gained` as much speed.
  Jump jump(double since = 0, double gained = 0) const {
    Impacts impacts;
    for (const Touch& touch : touches) impacts.meetings.push_back({touch, since, gained});
    return after_jump(scene, motion.q, motion.v, impacts, flexibility);
  }

  double mass(ElementIndex e) const { return scene.bodies()[e].mass(0, 0); }
  double inertia(ElementIndex e) const { return scene.bodies()[e].mass(2, 2); }

  /// Momentum, and angular momentum about the origin.
  Eigen::Vector3d momentum(const UnknownsTable& q, const UnknownsTable& v) const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (ElementIndex e : indices(v)) {
      if (v[e].size() == 0) continue;
      const Point centre = scene.reference.centroids[e] + Point{q[e][0], q[e][1]};
      sum += Eigen::Vector3d(mass(e) * v[e][0], mass(e) * v[e][1],
                             mass(e) * cross(centre, {v[e][0], v[e][1]}) + inertia(e) * v[e][2]);
    }
    return sum;
  }
  double energy(const UnknownsTable& v) const { return kinetic_energy(scene, v); }
};

void expect_velocity(const Unknowns& v, double x, double y, double turn, double tolerance = kRounding) {
  EXPECT_NEAR(v[0], x, tolerance);
  EXPECT_NEAR(v[1], y, tolerance);
  EXPECT_NEAR(v[2], turn, tolerance);
}

/// Squares of 1 m side by side.
Blocks side_by_side(int count) {
  Blocks blocks;
  for (int i = 0; i < count; ++i) blocks.blocks.push_back(rectangle({1.0 * i, 0}, {1.0 + i, 1}));
  return blocks;
}

/// A fixed floor, its top at y = 0, under a square of 1 m.
Blocks on_floor() {
  Blocks blocks;
  blocks.blocks = {rectangle({-2, -1}, {3, 0}), rectangle({0, 0}, {1, 1})};
  blocks.fixed_points = {{{-1, -0.5}, 0, {}}, {{2, -0.5}, 0, {}}};
  return blocks;
}

/// The same square rotated about its lowest corner, which is in contact with the floor at the origin.
Blocks on_its_corner(double angle) {
  Blocks blocks = on_floor();
  blocks.blocks[1] = support::turned_rectangle({0, 0}, {1, 1}, angle);
  return blocks;
}

/// Returns the velocity of a rigid body after one of its points met the fixed plane y = 0: restitution e of the normal
/// velocity. Friction sticks if the cone has room, else it is on the cone, against the slip. `arm` leads from the
/// centroid to the point.
Eigen::Vector3d struck_by_plane(double mass, double inertia, Point arm, const Eigen::Vector3d& v, double e, double mu) {
  Eigen::Matrix<double, 2, 3> g;
  g << 0, 1, arm.x, 1, 0, -arm.y;  // normal, then along x
  const Eigen::Vector3d inverse(1 / mass, 1 / mass, 1 / inertia);
  const Eigen::Matrix2d w = g * inverse.asDiagonal() * g.transpose();
  const Eigen::Vector2d u = g * v;
  Eigen::Vector2d p = w.inverse() * Eigen::Vector2d(-(1 + e) * u[0], -u[1]);
  if (std::abs(p[1]) > mu * p[0]) {
    for (const double sign : {-1.0, 1.0}) {
      p[0] = -(1 + e) * u[0] / (w(0, 0) + sign * mu * w(0, 1));
      p[1] = sign * mu * p[0];
      if (sign * (u + w * p)[1] <= 0) break;
    }
  }
  return v + inverse.asDiagonal() * (g.transpose() * p);
}

}  // namespace

// v1' = (P - m2 e (v1 - v2))/M, v2' = (P + m1 e (v1 - v2))/M; the energy of relative motion falls by 1 - e².
TEST(Impact, blocks_that_meet_centrally_part_by_restitution) {
  for (const double e : {0.0, 0.3, 1.0}) {
    for (const double heavier : {1.0, 4.0, 100.0}) {
      Struck struck(side_by_side(2), {1000, 1000 * heavier}, e);
      ASSERT_EQ(struck.touches.size(), 2);
      struck.move(kFirst, 2, 0.5);
      struck.move(kSecond, -1, 0.5);
      const Jump jump = struck.jump();
      const double m1 = struck.mass(kFirst), m2 = struck.mass(kSecond), all = m1 + m2;
      EXPECT_NEAR(m1, 1000, 1e-9);
      const double mean = (2 * m1 - m2) / all;
      // Impulses are solved to a fraction of the largest momentum.
      expect_velocity(jump.v[kFirst], mean - 3 * e * m2 / all, 0.5, 0, kRounding * heavier);
      expect_velocity(jump.v[kSecond], mean + 3 * e * m1 / all, 0.5, 0);
      const double lost = (1 - e * e) * m1 * m2 / all * 9 / 2;
      EXPECT_NEAR(jump.lost, lost, 1e-10 * struck.energy(struck.motion.v)) << e << ' ' << heavier;
      EXPECT_NEAR(struck.energy(struck.motion.v) - struck.energy(jump.v), lost, 1e-10 * struck.energy(jump.v));
      EXPECT_EQ(jump.given, 0);
      EXPECT_TRUE(jump.undecided.empty());
    }
  }
}

TEST(Impact, blocks_that_part_are_left_alone) {
  Struck struck(side_by_side(2), {1000, 3000}, 0.5);
  struck.move(kFirst, -1, 0.2, 0);
  struck.move(kSecond, 1, -0.3, 0);
  const Jump jump = struck.jump(1e-4);
  expect_velocity(jump.v[kFirst], -1, 0.2, 0, 0);
  expect_velocity(jump.v[kSecond], 1, -0.3, 0, 0);
  EXPECT_EQ(jump.q[kFirst], struck.motion.q[kFirst]);
  EXPECT_EQ(jump.lost, 0);
}

// Two corners meet at once; the law that both rebound decides how they share the impact.
TEST(Impact, a_block_that_falls_flat_does_not_turn) {
  for (const double e : {0.0, 0.5, 1.0}) {
    Struck struck(on_floor(), {2500, 2500}, e, 30);
    ASSERT_EQ(struck.touches.size(), 2);
    struck.move(kSecond, 0, -3);
    expect_velocity(struck.jump().v[kSecond], 0, 3 * e, 0);
  }
}

// A wide block with contacts at three places of one line, which could share the impact in any way.
TEST(Impact, a_block_that_falls_on_three_supports_does_not_turn) {
  Blocks blocks;
  blocks.blocks = {rectangle({0, -1}, {1, 0}), rectangle({2, -1}, {3, 0}), rectangle({4, -1}, {5, 0}),
                   rectangle({0, 0}, {5, 0.5})};
  for (int i = 0; i < 3; ++i)
    for (const double x : {0.2, 0.8}) blocks.fixed_points.push_back({{2 * i + x, -0.5}, i, {}});
  Struck struck(blocks, {2500, 2500, 2500, 2500}, 0.4);
  ASSERT_EQ(struck.touches.size(), 6);
  struck.move(ElementIndex{3}, 0.3, -2);
  const Jump jump = struck.jump();
  expect_velocity(jump.v[ElementIndex{3}], 0.3, 0.8, 0);
  EXPECT_NEAR(jump.lost, (1 - 0.16) * struck.mass(ElementIndex{3}) * 2, 1e-8);
}

// From an impact that sticks to one that slides either way, with and without spin.
TEST(Impact, an_oblique_blow_obeys_newton_and_coulomb) {
  int sticking = 0, sliding = 0;
  for (const double angle : {0.2, 0.7, 1.2}) {
    for (const double along : {-4.0, -0.5, 0.0, 0.8, 5.0}) {
      for (const double turn : {-1.5, 0.0, 2.0}) {
        for (const double e : {0.0, 0.6}) {
          Struck struck(on_its_corner(angle), {2500, 2500}, e, 25);
          ASSERT_EQ(struck.touches.size(), 1);
          const double mu = std::tan(support::radians(25));
          const Point arm = Point{} - struck.scene.reference.centroids[kSecond];
          const Eigen::Vector3d before(along, -3, turn);
          struck.motion.v[kSecond] = before;
          const double m = struck.mass(kSecond), inertia = struck.inertia(kSecond);
          const Eigen::Vector3d expected = struck_by_plane(m, inertia, arm, before, e, mu);
          const Jump jump = struck.jump();
          const Eigen::Vector3d found = jump.v[kSecond];
          EXPECT_LT((found - expected).norm(), 1e-11) << angle << ' ' << along << ' ' << turn << ' ' << e;
          const Eigen::Vector2d impulse = m * (found - before).head<2>();
          EXPECT_LE(std::abs(impulse[0]), mu * impulse[1] * (1 + 1e-11));
          (std::abs(impulse[0]) < 0.999 * mu * impulse[1] ? sticking : sliding) += 1;
          // Without restitution no impulse does positive work.
          if (e == 0) {
            EXPECT_LE(struck.energy(jump.v), struck.energy(struck.motion.v));
          }
          EXPECT_NEAR(struck.energy(struck.motion.v) - struck.energy(jump.v), jump.lost, 1e-9 * m);
        }
      }
    }
  }
  EXPECT_GT(sticking, 10);
  EXPECT_GT(sliding, 10);
}

// The surfaces met a while ago: places after the jump are those of a motion with the new velocity since then, about
// which angular momentum is kept.
TEST(Impact, a_blow_within_the_step_keeps_momentum_and_angular_momentum) {
  for (const double since : {0.0, 1e-3, 0.02}) {
    Blocks blocks;
    blocks.blocks = {rectangle({0, 0}, {1, 1}), support::turned_rectangle({0, 0}, {1, 1}, 0.3)};
    const Point leftmost = blocks.blocks[1].outer[3].position;
    for (BlockVertex& corner : blocks.blocks[1].outer) corner.position = corner.position + (Point{1, 0.3} - leftmost);
    Struck struck(blocks, {2500, 1000}, 0.5, 30);
    ASSERT_EQ(struck.touches.size(), 1);
    struck.move(kFirst, 1, 0.2, 0.5);
    struck.move(kSecond, -1.5, 0.1, -0.7);
    const Jump jump = struck.jump(since);
    const Eigen::Vector3d was = struck.momentum(struck.motion.q, struck.motion.v);
    const Eigen::Vector3d is = struck.momentum(jump.q, jump.v);
    EXPECT_GT(jump.lost, 100);
    EXPECT_LT((is - was).cwiseAbs().maxCoeff(), kRounding * 2500) << since;
    for (const ElementIndex e : {kFirst, kSecond}) {
      const Unknowns way = jump.q[e] - struck.motion.q[e], change = jump.v[e] - struck.motion.v[e];
      EXPECT_LT((way - since * change).norm(), kRounding);
    }
  }
}

// A block falls on the floor with speed w and goes on falling for a time t in the step that finds it. Thrown up at e w
// then, it would be at e w t - g t²/2 with e w - g t.
TEST(Impact, speed_gained_since_the_meeting_is_not_thrown_back) {
  const double speed = 3, time = 0.01, gravity = 9.81, e = 0.6;
  Struck struck(on_floor(), {2500, 2500}, e);
  struck.motion.q[kSecond] << 0, -speed * time - gravity * time * time / 2, 0;
  struck.move(kSecond, 0, -speed - gravity * time);
  const Jump jump = struck.jump(time, gravity * time);
  expect_velocity(jump.v[kSecond], 0, e * speed - gravity * time, 0);
  EXPECT_NEAR(jump.q[kSecond][1], e * speed * time - gravity * time * time / 2, kRounding);
}

// Pulled through a bond: a wide block is driven away from a small one that is bonded to its back. They move on as one.
TEST(Impact, bonded_blocks_go_on_together) {
  Blocks blocks;
  blocks.blocks = {rectangle({1, 0}, {2, 3}), rectangle({0, 1}, {1, 2}), rectangle({0, 0}, {1, 0.9}),
                   rectangle({0, 2.1}, {1, 3})};
  for (const bool is_bonded : {true, false}) {
    Struck struck(blocks, {1000, 1000, 1000, 1000}, 0);
    struck.move(kThird, 5, 0);
    struck.move(ElementIndex{3}, 5, 0);
    Impacts impacts;
    for (const Touch& touch : struck.touches) {
      const bool is_small = struck.scene.model.vertices[touch.vertex].element == kSecond ||
                            struck.scene.model.vertices[touch.start].element == kSecond;
      if (!is_small) impacts.meetings.push_back({touch, 0, 0});
      if (is_small) impacts.touching.push_back(touch);
      if (is_small && is_bonded) impacts.bonds[touch.facing] = {};
    }
    ASSERT_EQ(impacts.meetings.size(), 4);
    ASSERT_EQ(impacts.touching.size(), 2);
    const Jump jump = after_jump(struck.scene, struck.motion.q, struck.motion.v, impacts, struck.flexibility);
    const double moved = is_bonded ? 1800 + 3000 + 1000 : 1800 + 3000;
    expect_velocity(jump.v[kFirst], 1800 * 5 / moved, 0, 0);
    expect_velocity(jump.v[kSecond], is_bonded ? 1800 * 5 / moved : 0, 0, 0);
  }
}

// A block in contact with a struck block moves with it, but without restitution of its own.
TEST(Impact, a_blow_goes_through_what_touches) {
  const double e = 0.5;
  Struck struck(side_by_side(3), {1000, 1000, 1000}, e);
  struck.move(kFirst, 3, 0);
  Impacts impacts;
  for (const Touch& touch : struck.touches) {
    const bool is_first = struck.scene.model.vertices[touch.vertex].element == kFirst ||
                          struck.scene.model.vertices[touch.start].element == kFirst;
    if (is_first) impacts.meetings.push_back({touch, 0, 0});
    if (!is_first) impacts.touching.push_back(touch);
  }
  const Jump jump = after_jump(struck.scene, struck.motion.q, struck.motion.v, impacts, struck.flexibility);
  // m (v1 + 2 v') = 3 m, v' - v1 = 3 e.
  const double together = (3 + 3 * e) / 3;
  expect_velocity(jump.v[kFirst], together - 3 * e, 0, 0);
  expect_velocity(jump.v[kSecond], together, 0, 0);
  expect_velocity(jump.v[kThird], together, 0, 0);
}

// The floor rises at 2 m/s, driven by its points. The block leaves it at e times the speed of approach, and the floor
// gives the work of the impact on its way.
TEST(Impact, a_driven_floor_keeps_its_velocity_and_gives_energy) {
  const TimeCurve rises{{0, 10}, {{0, 0}, {0, 20}}, {}};
  const double e = 0.5;
  Struck struck(on_floor(), {2500, 2500}, e, 0, {rises, rises});
  ASSERT_EQ(struck.scene.held.size(), 2);
  struck.move(kFirst, 0, 2);
  struck.move(kSecond, 0, -1);
  const Jump jump = struck.jump();
  expect_velocity(jump.v[kFirst], 0, 2, 0);
  expect_velocity(jump.v[kSecond], 0, 2 + 3 * e, 0);
  const double impulse = 2500 * 3 * (1 + e);
  EXPECT_NEAR(jump.given, impulse * 2, 1e-8);
  EXPECT_NEAR(jump.lost, 2500 * 9 * (1 - e * e) / 2, 1e-8);
  EXPECT_NEAR(struck.energy(jump.v), struck.energy(struck.motion.v) + jump.given - jump.lost, 1e-8);
}

// One point of a free block is driven: p = W⁻¹ (wanted - had), W that of a point at its arm.
TEST(Impact, a_driven_point_takes_the_velocity_of_its_motion) {
  const TimeCurve driven{{0, 1}, {{0, 0}, {0.8, -0.6}}, {}};
  Blocks blocks;
  blocks.blocks = {rectangle({0, 0}, {1, 1})};
  blocks.fixed_points = {{{0.9, 0.2}, 0, {}}};
  Struck struck(blocks, {2000}, 0, 0, {driven});
  struck.move(kFirst, 0.1, 0.3, -0.4);
  const Eigen::Vector3d before = struck.motion.v[kFirst];
  Eigen::Matrix<double, 2, 3> g;
  g << 1, 0, 0.3, 0, 1, 0.4;  // of the arm (0.4, -0.3)
  const Eigen::Matrix3d inverse = Eigen::Vector3d(1 / 2000.0, 1 / 2000.0, 6 / 2000.0).asDiagonal();
  const Eigen::Vector2d p = (g * inverse * g.transpose()).inverse() * (Eigen::Vector2d(0.8, -0.6) - g * before);
  const Eigen::Vector3d expected = before + inverse * g.transpose() * p;
  const PushedVelocities pushed =
      with_held_velocities(struck.scene, struck.motion.q, struck.motion.v, {}, {}, 0.25, 0.5, {struck.flexibility});
  expect_velocity(pushed.v[kFirst], expected[0], expected[1], expected[2]);
  EXPECT_NEAR(pushed.given, struck.energy(pushed.v) - struck.energy(struck.motion.v), 1e-9);
}

// Both corners are on the floor: the normal velocity vanishes; the other is kept, loses friction times it, or vanishes
// too.
TEST(Impact, closed_contacts_lose_their_normal_velocity) {
  Struck struck(on_floor(), {2500, 2500}, 0, 30);
  struck.move(kSecond, 2, -0.5);
  const auto after = [&](const HeldSlip& slip) {
    const std::vector<HeldSlip> slips(struck.touches.size(), slip);
    const PushAnswer answer{struck.flexibility};
    const UnknownsTable& v = struck.motion.v;
    return with_held_velocities(struck.scene, struck.motion.q, v, struck.touches, slips, 0, 1, answer).v[kSecond];
  };
  constexpr double kClose = 1e-11;
  expect_velocity(after({}), 2, 0, 0, kClose);
  expect_velocity(after({.sticks = true}), 0, 0, 0, kClose);
  // Friction of the push alone, towards the start of the edge of the floor or its end: the edge runs to the left.
  expect_velocity(after({.friction = 0.1}), 2 - 0.1 * 0.5, 0, 0, kClose);
  expect_velocity(after({.friction = -0.1}), 2 + 0.1 * 0.5, 0, 0, kClose);
  // Each contact had 5 times the mass as a normal impulse; with the push all of them have 10.5 times.
  const Eigen::Vector2d had(5 * 2500, 0);
  expect_velocity(after({.of_sum = ForceLaw{0.1}, .force = had}), 2 - 0.1 * 10.5, 0, 0, kClose);
  expect_velocity(after({.of_sum = ForceLaw{0.2}, .force = had}), 0, 0, 0, kClose);
  // The sum of force and push pulls nowhere: a block that leaves faster than the push would hold it goes on.
  struck.move(kSecond, 2, 0.5);
  const Eigen::Vector2d less(0.1 * 2500, 0);
  expect_velocity(after({.of_sum = ForceLaw{}, .force = less}), 2, 0.5 - 2 * 0.1, 0, kClose);
}

// In proportion to their overlap, the lighter one farther: their mass centre stays.
TEST(Impact, blocks_that_overlap_are_moved_apart_by_mass) {
  const double overlap = 1e-4;
  Blocks blocks;
  blocks.blocks = {rectangle({0, 0}, {1, 1}), rectangle({1 - overlap, 0}, {2 - overlap, 1})};
  Struck struck(blocks, {1000, 3000}, 0);
  struck.move(kFirst, 1, 0);
  const auto apart = [&](const Touches& impacts, const Touches& others) {
    return without_overlap(struck.scene, struck.motion.q, impacts, others, struck.motion.q, struck.flexibility);
  };
  Touches touches = struck.touches;
  for (Touch& touch : touches) touch.rest_gap = 0;
  const Separated separated = apart(touches, {});
  expect_velocity(separated.q[kFirst], -0.75 * overlap, 0, 0);
  expect_velocity(separated.q[kSecond], 0.25 * overlap, 0, 0);
  EXPECT_EQ(separated.locked, 0);
  for (Touch& touch : touches) touch.rest_gap = -0.4 * overlap;
  const Separated rested = apart(touches, {});
  expect_velocity(rested.q[kFirst], -0.75 * 0.6 * overlap, 0, 0);
  const Separated others = apart({}, touches);  // which may stay unchanged
  expect_velocity(others.q[kFirst], 0, 0, 0, 0);
  EXPECT_EQ(others.solves, 0);
}

// Fixed by two points that its motion wants elsewhere: the block is there, rotated as they are.
TEST(Impact, driven_points_are_put_where_their_motion_wants_them) {
  const double angle = 0.02;
  std::vector<TimeCurve> motions;
  Blocks blocks;
  blocks.blocks = {rectangle({0, 0}, {1, 1})};
  for (const Point at : {Point{0.2, 0.5}, Point{0.8, 0.5}}) {
    blocks.fixed_points.push_back({at, 0, {}});
    const Point arm = at - Point{0.5, 0.5};
    motions.push_back({{0, 1}, {{0, 0}, Point{0.3, -0.1} + (turned(arm, angle) - arm)}, {}});
  }
  Struck struck(blocks, {2000}, 0, 0, motions);
  ASSERT_EQ(struck.scene.held.size(), 2);
  const UnknownsTable placed = with_points_in_place(struck.scene, struck.motion.q, 1, struck.flexibility);
  expect_velocity(placed[kFirst], 0.3, -0.1, angle, 1e-10);
}

TEST(Impact, the_rigid_part_of_a_velocity_has_no_strain_rates) {
  UnknownsTable v(2, Unknowns(6));
  v[kFirst] << 1, 2, 3, 4, 5, 6;
  v[kSecond] = Eigen::Vector3d(7, 8, 9);
  const UnknownsTable rigid = rigid_part(v);
  EXPECT_EQ(rigid[kFirst], Unknowns((Unknowns(6) << 1, 2, 3, 0, 0, 0).finished()));
  EXPECT_EQ(rigid[kSecond], v[kSecond]);
}

}  // namespace keyblock::impact_test
