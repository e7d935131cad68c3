// Numbers of old files are read in any spelling, and written so that they read back the same.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/text/numbers.hpp"

#include <gtest/gtest.h>

#include <array>
#include <charconv>
#include <cmath>
#include <random>
#include <string>

namespace keyblock::formats::numbers_test {
namespace {

std::string rounded(double value) {
  std::string text;
  append_rounded(text, value);
  return text;
}

std::string by_the_library(double value) {
  std::array<char, 40> digits;
  return {digits.data(), std::to_chars(digits.begin(), digits.end(), value, std::chars_format::general, 12).ptr};
}

}  // namespace

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

TEST(Numbers, twelve_digits_are_those_of_the_library) {
  for (const double value : {0.0,
                             -0.0,
                             1.0,
                             -1.0,
                             10.0,
                             0.1,
                             1e-4,
                             1e-5,
                             99999999999.0,
                             999999999999.5,
                             1e12,
                             1e11,
                             999999999999.4,
                             0.00099999999999999,
                             123456789012.5,
                             1234567890122.5,
                             1e300,
                             1e-310,
                             5e-324,
                             std::nan(""),
                             -HUGE_VAL,
                             1e22,
                             1e23,
                             1e33,
                             1e34,
                             1e-33,
                             1e-34})
    EXPECT_EQ(rounded(value), by_the_library(value));
  std::mt19937_64 random(53);
  std::uniform_real_distribution<double> size(-45, 45), digit(1, 10);
  std::uniform_int_distribution<std::int64_t> whole(-2'000'000'000'000, 2'000'000'000'000);
  for (int i = 0; i < 100'000; ++i) {
    const double value = (i % 2 == 0 ? 1 : -1) * digit(random) * std::pow(10, std::floor(size(random)));
    EXPECT_EQ(rounded(value), by_the_library(value));
    const double tie = static_cast<double>(whole(random)) / (i % 3 == 0 ? 2 : i % 3 == 1 ? 16 : 1000);
    EXPECT_EQ(rounded(tie), by_the_library(tie));
  }
}

}  // namespace keyblock::formats::numbers_test
