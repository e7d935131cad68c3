// States of contacts after a solve: change of line, instant of contact, reversal (legacy-rules 10).
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/contact/judge.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/scenes.hpp"

namespace keyblock::judge_test {
namespace {

using support::legacy_scene;
using support::plain_analysis;
using support::rectangle;

/// A base (vertices 0 … 3, top 3 → 2 at y = 0, right side 2 → 1 at x = 3) and a triangle standing on vertex 4.
struct TipOnBase {
  ShiScene scene;
  State state;
  Contact contact;

  explicit TipOnBase(Point tip, double friction_deg = 0) : scene(make(tip, friction_deg)), state(start(scene).state) {
    contact.first = {{4}, {3}, {2}};
  }

  static ShiScene make(Point tip, double friction_deg) {
    const BlockPolygon upper{0, {{tip, 0}, {tip + Point{1, 1}, 0}, {tip + Point{0, 1}, 0}}, {}};
    Analysis analysis = plain_analysis(1e-3, 1);
    analysis.joint_materials[0].friction_angle_deg = friction_deg;
    return legacy_scene({{rectangle({-2, -1}, {3, 0}), upper}, {}, {}, {}, {}, {}}, analysis);
  }

  Contact after(Point move) const {
    Increments increments(2);
    increments[ElementIndex{0}] = Unknowns::Zero(6);
    increments[ElementIndex{1}] = Unknowns::Zero(6);
    increments[ElementIndex{1}].head<2>() << move.x, move.y;
    return judge({contact}, scene.model, state, increments, scene.rules, 1e9)[0];
  }
};

/// Tip in the corner (3, 0): distance from the first line is its way up, from the second its way to the right.
TipOnBase in_the_corner(ContactState state) {
  TipOnBase pair({3, 0});
  pair.contact.kind = ContactKind::vertex_vertex;
  pair.contact.second = {{4}, {2}, {1}};
  pair.contact.state = state;
  return pair;
}

constexpr double kFar = 0x1p-10;  // farther than closing depth and opening distance

}  // namespace

TEST(Judge, an_open_vertex_vertex_contact_closes_on_the_line_it_is_less_deep_in) {
  const TipOnBase pair = in_the_corner(ContactState::open);
  ASSERT_GT(kFar, pair.scene.rules.closing_depth);
  EXPECT_EQ(pair.after({-2 * kFar, -kFar}).state, ContactState::on_first_line);
  EXPECT_EQ(pair.after({-kFar, -2 * kFar}).state, ContactState::on_second_line);
  EXPECT_EQ(pair.after({-kFar, -kFar}).state, ContactState::on_first_line);
  EXPECT_EQ(pair.after({-kFar, -2 * kFar}).distance, -kFar);
}

TEST(Judge, an_open_vertex_vertex_contact_stays_open_while_it_is_outside_of_either_line) {
  const TipOnBase pair = in_the_corner(ContactState::open);
  EXPECT_TRUE(pair.after({kFar, -kFar}).is_open());
  EXPECT_TRUE(pair.after({-kFar, kFar}).is_open());
  EXPECT_TRUE(pair.after({-kFar, -0.9 * pair.scene.rules.closing_depth}).is_open());
}

// Legacy-rules 10.2: at a change of the line, the distance to the line active before decides, though that to the new
// line is kept.
TEST(Judge, a_vertex_vertex_contact_that_changes_line_opens_by_the_line_active_before) {
  const Contact to_second = in_the_corner(ContactState::on_first_line).after({kFar, -kFar});
  EXPECT_EQ(to_second.state, ContactState::on_second_line);
  EXPECT_EQ(to_second.distance, kFar);
  EXPECT_EQ(to_second.state_before, ContactState::on_first_line);
  const Contact to_first = in_the_corner(ContactState::on_second_line).after({-kFar, kFar});
  EXPECT_EQ(to_first.state, ContactState::on_first_line);
  EXPECT_EQ(to_first.distance, kFar);
  EXPECT_TRUE(in_the_corner(ContactState::on_first_line).after({2 * kFar, kFar}).is_open());
}

TEST(Judge, a_vertex_vertex_contact_that_keeps_its_line_opens_by_that_line) {
  EXPECT_TRUE(in_the_corner(ContactState::on_first_line).after({-kFar, kFar}).is_open());
  EXPECT_TRUE(in_the_corner(ContactState::on_second_line).after({kFar, -kFar}).is_open());
  EXPECT_EQ(in_the_corner(ContactState::on_first_line).after({-2 * kFar, -kFar}).state, ContactState::on_first_line);
}

// Legacy-rules 10.3. From x = 1 at height 0.01, falling 0.04 while moving 0.8: contact begins after a quarter of the
// way.
TEST(Judge, the_contact_point_is_where_the_vertex_is_at_the_instant_of_touching) {
  const Contact touched = TipOnBase({1, 0.01}).after({0.8, -0.04});
  ASSERT_FALSE(touched.is_open());
  EXPECT_NEAR(touched.ratio, (1.2 + 2) / 5, 1e-12);
  EXPECT_NEAR(touched.slip, 0.6, 1e-12) << "the way after touching";
}

TEST(Judge, a_vertex_that_lay_inside_already_touches_where_it_started) {
  for (double rise : {-0.01, 0.005}) {  // the ways to the line would be -1 and 2 of the step's
    const Contact touched = TipOnBase({1, -0.01}).after({0.8, rise});
    ASSERT_FALSE(touched.is_open());
    EXPECT_NEAR(touched.ratio, 0.6, 1e-12) << rise;
    EXPECT_NEAR(touched.slip, 0.8, 1e-12) << rise;
  }
}

// Neither the factor 2.5 nor cohesion helps a contact that closes.
TEST(Judge, a_closing_contact_locks_within_plain_friction) {
  const double limit = 0.01 * std::tan(30 * std::numbers::pi / 180);
  for (const auto& [share, state] : {std::pair{0.99, ContactState::locked}, std::pair{1.01, ContactState::sliding}}) {
    TipOnBase pair({1, -0.01}, 30);
    pair.scene.model.joint_materials[0].cohesion = 1e9;
    pair.contact.bonded = true;
    pair.contact.length = 1;
    EXPECT_EQ(pair.after({share * limit, 0}).state, state) << share;
  }
}

TEST(Judge, a_locked_contact_drawn_apart_has_no_friction) {
  TipOnBase pair({1, 0}, 45);
  pair.contact.state = ContactState::locked;
  pair.contact.ratio = 0.6;
  pair.contact.bonded = true;
  pair.contact.length = 1;
  pair.scene.model.joint_materials[0].tensile_strength = 1e7;  // holds to a stretch of 0.01
  EXPECT_EQ(pair.after({1e-5, 1e-3}).state, ContactState::sliding);
  EXPECT_EQ(pair.after({1e-5, -1e-3}).state, ContactState::locked);
}

// Legacy-rules 10.3: sgn(old slip) slip < -1e-7 w0 and phi > 0.9 degrees; w0 = 2.5.
TEST(Judge, turning_back_locks_above_nine_tenths_of_a_degree_and_a_ten_millionth_of_the_scene) {
  struct Row {
    double friction_deg;
    double slip;
    ContactState expected;
  };
  for (const Row& row : {Row{0.9, -1e-3, ContactState::sliding}, Row{0.91, -1e-3, ContactState::locked},
                         Row{30, -2e-7, ContactState::sliding}, Row{30, -3e-7, ContactState::locked},
                         Row{30, 1e-3, ContactState::sliding}}) {
    for (double way : {1.0, -1.0}) {
      TipOnBase pair({1, 0}, row.friction_deg);
      ASSERT_DOUBLE_EQ(pair.scene.rules.scale, 2.5);
      pair.contact.state = ContactState::sliding;
      pair.contact.ratio = 0.6;
      pair.contact.slip = way * 0.01;
      EXPECT_EQ(pair.after({way * row.slip, -1e-3}).state, row.expected) << row.friction_deg << " " << way * row.slip;
    }
  }
}

TEST(Judge, changed_are_those_that_opened_or_closed_but_not_those_that_began_to_slide) {
  Contacts contacts(4);
  contacts[0].state = ContactState::locked;
  contacts[1].state = ContactState::sliding;
  contacts[1].state_before = ContactState::locked;
  contacts[2].state_before = ContactState::sliding;
  EXPECT_EQ(changed(contacts), (std::vector<std::size_t>{0, 2}));
}

}  // namespace keyblock::judge_test
