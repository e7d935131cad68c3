// Distances by hand.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/nearest.hpp"

#include <gtest/gtest.h>

namespace keyblock::nearest_test {
namespace {

TEST(Nearest, counts_letters_put_in_taken_out_exchanged_and_swapped) {
  EXPECT_EQ(edit_distance("", ""), 0U);
  EXPECT_EQ(edit_distance("", "abc"), 3U);
  EXPECT_EQ(edit_distance("penalty", "penalty"), 0U);
  EXPECT_EQ(edit_distance("penaly", "penalty"), 1U);
  EXPECT_EQ(edit_distance("pennalty", "penalty"), 1U);
  EXPECT_EQ(edit_distance("penalti", "penalty"), 1U);
  EXPECT_EQ(edit_distance("pealnty", "penalty"), 2U);
  EXPECT_EQ(edit_distance("penatly", "penalty"), 1U);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
}

TEST(Nearest, names_what_is_near_and_nothing_that_is_far) {
  const std::vector<std::string> names{"linear_method", "contact_penalty", "steps"};
  EXPECT_EQ(nearest("linear_metod", names), "linear_method");
  EXPECT_EQ(nearest("contact_penalti", names), "contact_penalty");
  EXPECT_EQ(nearest("step", names), "steps");
  EXPECT_EQ(nearest("colour", names), "");
  EXPECT_EQ(nearest("", names), "");
  EXPECT_EQ(nearest("ab", {"cd", "ef"}), "");
}

TEST(Nearest, a_name_that_is_none_of_a_list_is_refused_with_the_list) {
  EXPECT_EQ(unless_one_of("steps", {"steps", "time"}), "");
  EXPECT_EQ(unless_one_of("far", {"steps", "time"}), "expected one of steps, time, found \"far\"");
  EXPECT_EQ(unless_one_of("step", {"steps", "time"}),
            "expected one of steps, time, found \"step\"; did you mean \"steps\"?");
}

}  // namespace
}  // namespace keyblock::nearest_test
