// Closed contacts are found by the name of their contact, else by the facing of their twin.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/scene/contact_memory.hpp"

#include <gtest/gtest.h>

namespace keyblock::contact_memory_test {
namespace {

Touch touch(int vertex, int start, Facing facing = {}) {
  Touch made{{vertex}, {start}, {start + 1}};
  made.facing = facing;
  return made;
}

ContactMemory force(double normal) {
  ContactMemory memory;
  memory.normal = normal;
  return memory;
}

const Facing kFacing{{10}, {20}, 1};

}  // namespace

// A spring of compliance 1e-3 carries 2 and is compressed by 0.01: 0.008 more than by its force.
TEST(ContactMemory, a_part_of_a_step_counts_its_part_of_the_excess_of_a_spring) {
  ContactMemory memory = force(2);
  memory.normal_compliance = 1e-3;
  memory.compression = 0.01;
  memory.removed_in = 0.5;
  EXPECT_EQ(memory.counted(-0.01, 0.5), -0.01);
  EXPECT_EQ(memory.counted(-0.01, 1), -0.01);
  EXPECT_DOUBLE_EQ(memory.counted(-0.01, 0.25), -0.006);
  EXPECT_DOUBLE_EQ(memory.counted(-0.01, 0.05), -0.004);  // at least as much as by the force
  EXPECT_EQ(memory.counted(-0.001, 0.125), -0.001);
  EXPECT_EQ(memory.counted(0.02, 0.125), 0.02);
  memory.compression = 0.001;  // less than by its force
  EXPECT_EQ(memory.counted(-0.001, 0.125), -0.001);
}

TEST(ClosedContacts, are_found_in_whatever_order_they_came) {
  const ClosedContacts closed({{touch(7, 3), force(1)}, {touch(2, 9), force(2)}, {touch(7, 1), force(3)}});
  ASSERT_EQ(closed.size(), 3U);
  EXPECT_EQ(closed.of(touch(7, 3))->normal, 1);
  EXPECT_EQ(closed.of(touch(2, 9))->normal, 2);
  EXPECT_EQ(closed.of(touch(7, 1))->normal, 3);
  EXPECT_EQ(closed.of(touch(7, 2)), nullptr);
  EXPECT_EQ(closed.at({7}).size(), 2U);
  EXPECT_EQ(closed.at({7})[0].memory.normal, 3);
  EXPECT_TRUE(closed.at({5}).empty());
}

TEST(ClosedContacts, the_last_of_equal_touches_counts) {
  const ClosedContacts closed({{touch(1, 2), force(1)}, {touch(4, 2), force(5)}, {touch(1, 2), force(9)}});
  ASSERT_EQ(closed.size(), 2U);
  EXPECT_EQ(closed.of(touch(1, 2))->normal, 9);
}

TEST(ClosedContacts, a_twin_on_the_other_edge_of_a_facing_inherits) {
  const ClosedContacts closed({{touch(1, 2, kFacing), force(4)}, {touch(3, 6), force(8)}});
  EXPECT_EQ(closed.of(touch(5, 9, kFacing))->normal, 4);
  EXPECT_EQ(closed.of(touch(5, 9, {{10}, {20}, 2})), nullptr);
  EXPECT_EQ(closed.of(touch(5, 9)), nullptr);
  const ClosedContacts two({{touch(8, 2, kFacing), force(6)}, {touch(1, 2, kFacing), force(4)}});
  EXPECT_EQ(two.of(touch(5, 9, kFacing))->normal, 6);  // that of the last contact by name
  EXPECT_EQ(two.of(touch(1, 2, kFacing))->normal, 4);
}

TEST(ClosedContacts, none_are_none) {
  const ClosedContacts none;
  EXPECT_EQ(none.size(), 0U);
  EXPECT_EQ(none.of(touch(1, 2, kFacing)), nullptr);
  EXPECT_TRUE(none.at({1}).empty());
}

}  // namespace keyblock::contact_memory_test
