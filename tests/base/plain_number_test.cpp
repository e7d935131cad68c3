// Coordinates of surveys are printed with all digits, without powers of ten.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/words/plain_number.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

namespace keyblock::plain_number_test {

TEST(PlainNumber, large_numbers_have_all_digits_before_the_point_and_small_ones_few) {
  EXPECT_EQ(plain(12470), "12470");
  EXPECT_EQ(plain(12469.7), "12470");
  EXPECT_EQ(plain(-5412345.678), "-5412346");
  EXPECT_EQ(plain(1234.5), "1234");  // to even, as %g
  EXPECT_EQ(plain(0), "0");
  EXPECT_EQ(plain(100), "100");
  EXPECT_EQ(plain(0.5), "0.5");
  EXPECT_EQ(plain(7.3861), "7.386");
  EXPECT_EQ(plain(99999.6, 3), "100000");
  EXPECT_EQ(plain(3e12, 3), "3e+12");
  EXPECT_EQ(plain(2.5e-7, 3), "2.5e-07");
}

// If %g has no power of ten, both agree.
TEST(PlainNumber, it_is_what_g_writes_where_that_has_no_power_of_ten) {
  for (int i = 0; i < 2000; ++i) {
    const double value = std::pow(10.0, -3.9 + i * 0.0038) * (i % 2 == 0 ? 1 : -1);
    const std::string g = fmt::format("{:.4g}", value);
    if (g.find('e') == std::string::npos) {
      EXPECT_EQ(plain(value), g);
    } else {
      EXPECT_EQ(plain(value).find('e'), std::string::npos) << g;
    }
  }
}

}  // namespace keyblock::plain_number_test
