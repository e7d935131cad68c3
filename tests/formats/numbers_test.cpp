// Numbers of old files are read whatever their spelling, and written so that they read back the same.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/numbers.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <string>

namespace keyblock::formats {

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

TEST(Numbers, short_decimals_are_read_to_the_bit_as_the_c_library_reads_them) {
  std::mt19937 random(20010520);
  const auto below = [&](unsigned limit) { return static_cast<unsigned>(random()) % limit; };
  int taken = 0;
  for (int i = 0; i < 200000; ++i) {
    std::string text = std::array{"", "-", "+"}[below(3)];
    for (unsigned digits = below(12); digits > 0; --digits) text += static_cast<char>('0' + below(10));
    if (below(3) > 0) text += '.';
    for (unsigned digits = below(10); digits > 0; --digits) text += static_cast<char>('0' + below(10));
    if (below(3) == 0) text += std::array{"e", "E", "e-", "e+"}[below(4)] + std::to_string(below(40));
    const ShortReal number = parse_short_real(text.data(), text.data() + text.size());
    if (!number.end) continue;
    ++taken;
    char* end = nullptr;
    const double expected = std::strtod(text.c_str(), &end);
    ASSERT_EQ(std::bit_cast<std::uint64_t>(number.value), std::bit_cast<std::uint64_t>(expected)) << text;
    ASSERT_EQ(number.end - text.data(), end - text.c_str()) << text;
  }
  EXPECT_GT(taken, 100000);
}

TEST(Numbers, what_is_no_short_decimal_is_left_to_the_long_way) {
  for (const std::string text :
       {"", "-", ".", "+", "nan", "e5", "1e", "1e+", "1e23", "12345678901234567890", "9007199254740993", "1e1000"})
    EXPECT_EQ(parse_short_real(text.data(), text.data() + text.size()).end, nullptr) << text;
}

}  // namespace keyblock::formats
