// Pieces of joints: contacts of two bodies along one joint, whichever body has the points.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/columns/joint_sums.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "formats/columns/contact_columns.hpp"

namespace keyblock::formats::joint_sums_test {
namespace {

ContactFrame contact(int element, int other, int joint, Point at, double pressure) {
  ContactFrame own;
  own.element = element;
  own.other = other;
  own.joint_line = joint;
  own.condition = pressure > 0 ? ContactCondition::stick : ContactCondition::open;
  own.position = at;
  own.normal = element < other ? Point{0, -1} : Point{0, 1};
  own.normal_force = pressure;
  own.gap = pressure > 0 ? 0 : 0.25;
  return own;
}

FramePart pieces(const ContactFrames& contacts) {
  return joint_part(contact_part(contacts));
}

std::vector<int> whole(const FramePart& part, const char* name) {
  const auto numbers = part.at(name).integers();
  return {numbers.begin(), numbers.end()};
}

}  // namespace

TEST(JointSums, contacts_of_both_sides_of_a_joint_are_one_piece_with_their_sums_and_ends) {
  ContactFrame sliding = contact(1, 0, 4, {2, 3}, 5);
  sliding.condition = ContactCondition::slide;
  sliding.slip = -0.5;
  sliding.shear_force = 1;
  const FramePart part = pieces({contact(0, 1, 4, {1, 3}, 2), sliding, contact(1, 0, 4, {0, 3}, 0)});
  ASSERT_EQ(part.rows, 1U);
  EXPECT_EQ(whole(part, "block"), std::vector<int>{1});
  EXPECT_EQ(whole(part, "other"), std::vector<int>{2});
  EXPECT_EQ(whole(part, "joint"), std::vector<int>{5});
  EXPECT_EQ(whole(part, "contacts"), std::vector<int>{3});
  EXPECT_EQ(whole(part, "closed"), std::vector<int>{2});
  EXPECT_EQ(whole(part, "sliding"), std::vector<int>{1});
  EXPECT_EQ(part.at("normal_force").reals()[0], 7);
  EXPECT_EQ(part.at("shear_force").reals()[0], 1);
  EXPECT_EQ(part.at("greatest_gap").reals()[0], 0.25);
  EXPECT_EQ(part.at("greatest_slip").reals()[0], -0.5);
  const auto ends = part.at("ends").reals();
  EXPECT_EQ((std::vector<double>{ends.begin(), ends.end()}), (std::vector<double>{0, 3, 2, 3}));
}

TEST(JointSums, other_joints_and_other_bodies_are_pieces_of_their_own) {
  const FramePart part =
      pieces({contact(2, 0, 1, {0, 0}, 1), contact(0, 1, 1, {0, 0}, 1), contact(0, 1, -1, {0, 0}, 1)});
  EXPECT_EQ(whole(part, "block"), (std::vector<int>{1, 1, 1}));
  EXPECT_EQ(whole(part, "other"), (std::vector<int>{2, 2, 3}));
  EXPECT_EQ(whole(part, "joint"), (std::vector<int>{0, 2, 2}));
  EXPECT_EQ(pieces({}).rows, 0U);
}

TEST(JointSums, sums_do_not_depend_on_which_block_has_the_edge) {
  ContactFrame one{0, 1, 2, ContactCondition::slide, {}, {0, 1}, 0, 0, 3, -2};
  ContactFrame other{1, 0, 2, ContactCondition::stick, {}, {0, -1}, 0, 0, 3, -2};
  ContactFrame third;
  third.other = 1;
  third.joint_material = 1;
  const std::vector<JointSum> sums = joint_sums(contact_part({one, other, third}), JointsBy::bodies);
  ASSERT_EQ(sums.size(), 2U);
  EXPECT_EQ(sums[0].joint_material, 2);
  EXPECT_EQ(sums[0].closed, 0);
  EXPECT_EQ(sums[1].contacts, 2);
  EXPECT_EQ(sums[1].sliding, 1);
  EXPECT_EQ(sums[1].normal_force, 6);
  EXPECT_EQ(sums[1].shear_force, -4);
  EXPECT_EQ(sums[1].force, (Point{4, 6}));
}

}  // namespace keyblock::formats::joint_sums_test
