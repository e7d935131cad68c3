// Names and texts of files cannot control the terminal or break an XML file.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/printable.hpp"

#include <gtest/gtest.h>

#include "base/listed.hpp"

namespace keyblock::printable_test {

TEST(Printable, control_characters_are_written_out_and_all_else_stays) {
  EXPECT_EQ(printable("a\x1b[2J\x07\x7f\n"), "a\\x1b[2J\\x07\\x7f\\x0a");
  EXPECT_EQ(printable("\xc2\x9b 31m"), "\\x9b 31m") << "U+009B begins a sequence as ESC [ does";
  EXPECT_EQ(printable("Böschung µ …"), "Böschung µ …");
}

TEST(Printable, of_a_number_of_thousands_of_digits_the_first_hundred_are_shown) {
  EXPECT_EQ(printable("found " + std::string(9999, '7') + ", x"), "found " + std::string(100, '7') + "…, x");
  const std::string as_long_as_shown = std::string(100, '1') + "." + std::string(100, '2');
  EXPECT_EQ(printable(as_long_as_shown), as_long_as_shown);
}

TEST(Printable, bytes_that_are_no_utf8_become_replacement_characters) {
  const std::string sign = "\xef\xbf\xbd";
  EXPECT_EQ(valid_utf8("Böschung 45° 石"), "Böschung 45° 石");
  EXPECT_EQ(valid_utf8("B\xf6schung"), "B" + sign + "schung") << "Latin-1";
  EXPECT_EQ(valid_utf8("\xc0\x80"), sign + sign) << "overlong";
  EXPECT_EQ(valid_utf8("\xed\xa0\x80"), sign + sign + sign) << "a surrogate";
  EXPECT_EQ(valid_utf8("\xf0\x9f\x92"), sign + sign + sign) << "cut off";
}

TEST(Listed, ten_numbers_are_shown_and_how_many_there_are) {
  EXPECT_EQ(listed(std::vector<int>{3, 7, 12}), "3, 7, 12");
  EXPECT_EQ(listed(std::vector<int>(10, 1)), "1, 1, 1, 1, 1, 1, 1, 1, 1, 1");
  EXPECT_EQ(listed(std::vector<int>(2629, 1)), "1, 1, 1, 1, 1, 1, 1, 1, 1, 1, … (2629 in all)");
}

}  // namespace keyblock::printable_test
