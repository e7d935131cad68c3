// Messages about input carry file, line and column in the one agreed form.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/error.hpp"

#include <gtest/gtest.h>

namespace keyblock::error_test {

TEST(Error, input_error_reads_file_line_column_sentence) {
  const InputError error({"slope.geo", 14, 7}, "expected a joint material, found \"abc\"");
  EXPECT_STREQ(error.what(), "slope.geo:14:7: error: expected a joint material, found \"abc\"");
}

TEST(Error, place_without_line_is_the_file_alone) {
  EXPECT_EQ(to_string(Place{"slope.geo"}), "slope.geo");
}

TEST(Error, warning_ends_with_its_name) {
  EXPECT_EQ(to_string(Warning{"joint_material_clamped", {"a.geo", 3, 0}, "joint material 9 taken as 1"}),
            "a.geo:3: warning: joint material 9 taken as 1 [joint_material_clamped]");
}

TEST(Error, a_list_of_warnings_ends_after_a_thousand_and_says_so) {
  Warnings warnings;
  for (int i = 1; i <= 5000; ++i) add_warning(warnings, {"odd", {"f", i, 0}, "odd"});
  ASSERT_EQ(warnings.size(), 1001u);
  EXPECT_EQ(warnings.back().name, "more_warnings");
  EXPECT_EQ(warnings.back().place, (Place{"f", 1001, 0}));
}

}  // namespace keyblock::error_test
