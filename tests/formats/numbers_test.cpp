// Numbers of old files are read in any spelling, and written so that they read back the same.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/text/numbers.hpp"

#include <gtest/gtest.h>

#include <string>

namespace keyblock::formats::numbers_test {

TEST(Numbers, old_spellings_are_read) {
  EXPECT_EQ(parse_real("1.0D+03"), 1000.0);
  EXPECT_EQ(parse_real("+.5"), 0.5);
  EXPECT_EQ(parse_real("5."), 5.0);
  EXPECT_EQ(parse_real("-1e-3"), -0.001);
}

TEST(Numbers, what_is_not_a_finite_number_is_refused) {
  for (const char* text : {"", "+", "nan", "inf", "-inf", "1x", "abc", "0x10", "1e999", "++1", "1 2"})
    EXPECT_EQ(parse_real(text), std::nullopt) << text;
}

TEST(Numbers, written_text_reads_back_the_same) {
  for (double value : {0.1, 1.0 / 3.0, 1e-300, 1.7976931348623157e308, -0.0, 24525.0})
    EXPECT_EQ(parse_real(format_real(value)), value);
}

}  // namespace keyblock::formats::numbers_test
