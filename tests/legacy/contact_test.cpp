// Two blocks on one another: their contacts, the initial state of these, and how they open, close, slide and lock.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "legacy/contact/carry.hpp"
#include "legacy/contact/detect.hpp"
#include "legacy/contact/judge.hpp"
#include "tests/support/scenes.hpp"

namespace keyblock::contact_test {
namespace {

using support::legacy_scene;
using support::plain_analysis;
using support::rectangle;

/// A unit square at height `gap` over a wide base; allowed displacement small, so that corners are distinguished.
struct SquareOnBase {
  ShiScene scene;
  State state;
  Contacts contacts;

  explicit SquareOnBase(double gap, double friction_deg = 0)
      : scene(make(gap, friction_deg)), state(start(scene).state) {
    contacts = detect(scene.model, state, scene.settings, scene.rules).contacts;
    contacts = carry(std::move(contacts), {}, state, scene.rules, scene.settings.quirks);
  }

  static ShiScene make(double gap, double friction_deg) {
    Analysis analysis = plain_analysis(1e-3, 1);
    analysis.allowed_displacement_ratio = 0.01;
    analysis.joint_materials[0] = {friction_deg, 1000, 500, {}};
    return legacy_scene({{rectangle({-2, -1}, {3, 0}), rectangle({0, gap}, {1, 1 + gap})}, {}, {}, {}, {}, {}},
                        analysis);
  }

  /// Judges after the square has moved rigidly by (dx, dy).
  void move(double dx, double dy) {
    Increments increments(2);
    increments[ElementIndex{0}] = Unknowns::Zero(6);
    increments[ElementIndex{1}] = Unknowns::Zero(6);
    increments[ElementIndex{1}].head<2>() << dx, dy;
    contacts = judge(std::move(contacts), scene.model, state, increments, scene.rules, scene.settings.contact_penalty);
  }
};

}  // namespace

TEST(Contact, a_square_on_a_wide_base_touches_with_its_two_lower_corners) {
  const SquareOnBase pair(0);
  ASSERT_EQ(pair.contacts.size(), 2U);
  for (const Contact& c : pair.contacts) {
    EXPECT_EQ(c.kind, ContactKind::vertex_edge);
    EXPECT_EQ(pair.scene.model.vertices[c.first.vertex].element, ElementIndex{1});
    EXPECT_NEAR(c.length, 0.5, 1e-9);  // half the overlap of the two edges (legacy-rules 5)
  }
}

TEST(Contact, far_apart_there_is_none) {
  EXPECT_TRUE(SquareOnBase(0.5).contacts.empty());
}

TEST(Contact, a_near_contact_starts_locked_in_a_dynamic_run_and_open_in_a_static_one) {
  SquareOnBase pair(0);
  for (const Contact& c : start_closed(pair.contacts, pair.state, pair.scene.rules)) {
    EXPECT_EQ(c.state, ContactState::locked);
    EXPECT_TRUE(c.bonded);
  }
  for (const Contact& c : start_open(pair.contacts)) EXPECT_TRUE(c.is_open());
}

TEST(Contact, an_open_contact_closes_only_after_the_closing_depth) {
  SquareOnBase pair(0);
  const double depth = pair.scene.rules.closing_depth;
  pair.move(0, -0.9 * depth);
  EXPECT_TRUE(pair.contacts[0].is_open());
  pair.move(0, -1.1 * depth);
  EXPECT_FALSE(pair.contacts[0].is_open());
  EXPECT_EQ(changed(pair.contacts).size(), 2U);
}

TEST(Contact, a_bonded_contact_opens_only_beyond_its_tensile_stretch) {
  SquareOnBase pair(0);
  pair.contacts = start_closed(pair.contacts, pair.state, pair.scene.rules);
  const double stretch = 500 * 0.5 / pair.scene.settings.contact_penalty + pair.scene.rules.opening_distance;
  pair.move(0, 0.9 * stretch);
  EXPECT_FALSE(pair.contacts[0].is_open());
  pair.move(0, 1.1 * stretch);
  EXPECT_TRUE(pair.contacts[0].is_open());
}

// Legacy-rules 10.3: locked while |penetration| tan(phi) + c length / kn > |slip| / 2.5.
TEST(Contact, a_locked_contact_slides_beyond_coulomb_and_cohesion) {
  for (const auto& [share, state] : {std::pair{0.99, ContactState::locked}, std::pair{1.01, ContactState::sliding}}) {
    SquareOnBase pair(0, 30);
    pair.contacts = start_closed(pair.contacts, pair.state, pair.scene.rules);
    const double depth = 1e-5;
    const double limit = 2.5 * (depth * std::tan(30 * M_PI / 180) + 1000 * 0.5 / pair.scene.settings.contact_penalty);
    pair.move(share * limit, -depth);
    EXPECT_EQ(pair.contacts[0].state, state) << share;
  }
}

TEST(Contact, a_sliding_contact_locks_when_it_turns_back) {
  SquareOnBase pair(0, 30);
  pair.contacts = start_closed(pair.contacts, pair.state, pair.scene.rules);
  pair.move(0.01, -1e-5);
  ASSERT_EQ(pair.contacts[0].state, ContactState::sliding);
  pair.move(0.02, -1e-5);
  EXPECT_EQ(pair.contacts[0].state, ContactState::sliding);
  pair.move(-0.01, -1e-5);
  EXPECT_EQ(pair.contacts[0].state, ContactState::locked);
}

// Legacy-rules 4: a step that ends sliding loses the bond and measures its slip anew; a locked one keeps both.
TEST(Contact, only_a_locked_contact_hands_on_bond_and_contact_point) {
  SquareOnBase pair(0);
  Contacts old = start_closed(pair.contacts, pair.state, pair.scene.rules);
  old[0].ratio = 0.123;
  old[1].ratio = 0.123;
  old[1].state = ContactState::sliding;
  const Contacts next = carry(detect(pair.scene.model, pair.state, pair.scene.settings, pair.scene.rules).contacts, old,
                              pair.state, pair.scene.rules, pair.scene.settings.quirks);
  EXPECT_EQ(next[0].state, ContactState::locked);
  EXPECT_TRUE(next[0].bonded);
  EXPECT_EQ(next[0].ratio, 0.123);
  EXPECT_EQ(next[1].state, ContactState::sliding);
  EXPECT_FALSE(next[1].bonded);
  EXPECT_NE(next[1].ratio, 0.123);
}

TEST(Contact, equal_squares_edge_to_edge_touch_by_parallel_pairs) {
  Analysis analysis = plain_analysis(1e-3, 1);
  analysis.allowed_displacement_ratio = 0.01;
  const ShiScene scene =
      legacy_scene({{rectangle({0, 0}, {1, 1}), rectangle({0, 1}, {1, 2})}, {}, {}, {}, {}, {}}, analysis);
  const Detection found = detect(scene.model, start(scene).state, scene.settings, scene.rules);
  ASSERT_EQ(found.contacts.size(), 2U);
  for (const Contact& c : found.contacts) {
    EXPECT_EQ(c.kind, ContactKind::vertex_edge);
    EXPECT_TRUE(c.parallel_pair);
  }
}

TEST(Contact, two_corners_that_meet_have_two_reference_lines) {
  Analysis analysis = plain_analysis(1e-3, 1);
  analysis.allowed_displacement_ratio = 0.01;
  const BlockPolygon tilted{0, {{{0, 1}, 0}, {{0.5, 2}, 0}, {{-0.5, 2}, 0}}, {}};  // a wedge on the tip of another
  const BlockPolygon tip{0, {{{-0.5, 0}, 0}, {{0.5, 0}, 0}, {{0, 1}, 0}}, {}};
  const ShiScene scene = legacy_scene({{tip, tilted}, {}, {}, {}, {}, {}}, analysis);
  const Detection found = detect(scene.model, start(scene).state, scene.settings, scene.rules);
  ASSERT_EQ(found.contacts.size(), 1U);
  EXPECT_EQ(found.contacts[0].kind, ContactKind::vertex_vertex);
  EXPECT_NE(found.contacts[0].first, found.contacts[0].second);
}

}  // namespace keyblock::contact_test
