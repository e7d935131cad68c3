// Shear failure of a bonded face: its points fail together, not one by one.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/scene/contact_laws.hpp"

#include <gtest/gtest.h>

namespace keyblock::contact_laws_test {
namespace {

// Two points of one face, each with half of c L = 100, and friction 0.5.
Touches ends_of_a_face() {
  Touches ends(2);
  ends[0].facing = {{1}, {5}, 0};
  ends[1].facing = {{1}, {5}, 2};
  return ends;
}

std::vector<Facing> sheared(const Eigen::Vector4d& forces) {
  ContactLaw law;
  law.is_bonded = true;
  law.force.friction = 0.5;
  law.shear_strength = 50;
  return sheared_bonds(ends_of_a_face(), {law, law}, forces, 1e-9);
}

}  // namespace

TEST(ContactLaws, a_face_holds_what_its_points_hold_together) {
  EXPECT_TRUE(sheared({0, 99, 0, 0}).empty());
  EXPECT_TRUE(sheared({40, 119, 0, 0}).empty());  // 100 + 0.5 · 40
  EXPECT_TRUE(sheared({0, 300, 0, -300}).empty());
}

TEST(ContactLaws, a_face_beyond_its_strength_loses_all_its_bonds) {
  EXPECT_EQ(sheared({0, 101, 0, 0}).size(), 2U);
  EXPECT_EQ(sheared({0, -60, 0, -60}).size(), 2U);
  EXPECT_EQ(sheared({-100, 51, 0, 0}).size(), 2U);  // pulled: 100 − 0.5 · 100
}

}  // namespace keyblock::contact_laws_test
