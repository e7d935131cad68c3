// Plain numbers are read eight characters at a time to the same bits as the C library reads them one by one.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/text/plain_real.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cctype>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <random>
#include <string>

namespace keyblock::formats::plain_real_test {
namespace {

/// Reads a word with `before` and `behind` about it.
std::optional<double> read_word(const std::string& word, const std::string& before = "12345.6 ",
                                const std::string& behind = " 12345.6") {
  const std::string text = before + word + behind;
  double value = 0;
  if (!read_plain_real(text, before.size(), before.size() + word.size(), value)) return std::nullopt;
  return value;
}

std::uint64_t bits(double value) {
  return std::bit_cast<std::uint64_t>(value);
}

}  // namespace

TEST(PlainReal, plain_numbers_have_the_bits_that_the_c_library_gives_them) {
  std::mt19937 random(20010520);
  const auto below = [&](unsigned limit) { return static_cast<unsigned>(random()) % limit; };
  int taken = 0;
  for (int i = 0; i < 300000; ++i) {
    std::string word = std::array{"", "-", "+"}[below(3)];
    for (unsigned digits = below(9); digits > 0; --digits) word += static_cast<char>('0' + below(10));
    if (below(3) > 0) word += '.';
    for (unsigned digits = below(10); digits > 0; --digits) word += static_cast<char>('0' + below(10));
    if (below(9) == 0) word.insert(below(static_cast<unsigned>(word.size()) + 1), 1, static_cast<char>(below(256)));
    if (word.empty() || std::isspace(static_cast<unsigned char>(word[0]))) continue;
    const auto value = read_word(word, std::string(8, static_cast<char>(below(256))));
    char* end = nullptr;
    const double expected = std::strtod(word.c_str(), &end);
    if (!value) continue;
    ++taken;
    ASSERT_EQ(end, word.c_str() + word.size()) << word;
    ASSERT_EQ(bits(*value), bits(expected)) << word;
  }
  EXPECT_GT(taken, 100000);
}

TEST(PlainReal, what_files_are_full_of_is_taken) {
  for (const std::string word :
       {"0", "1", "-7", "+3", "1234567", "0.5", "-40.142857", "9999999.99999999", "0.00000001"})
    EXPECT_EQ(read_word(word), std::strtod(word.c_str(), nullptr)) << word;
  EXPECT_EQ(bits(read_word("-0.0").value()), bits(-0.0));
}

TEST(PlainReal, other_words_are_left_to_the_long_way) {
  for (const std::string word :
       {"-",   ".",   "+",  "nan", "inf",      "1e5",         "1.5e3", "1.5d3", "1x",  "1.x",    "1.2.3",
        "--1", "+-1", ".5", "5.",  "12345678", "1.123456789", "0x10",  "1.2-3", "1-2", "\xff.5", "1.\xff"})
    EXPECT_EQ(read_word(word), std::nullopt) << word;
}

TEST(PlainReal, a_word_near_an_end_of_the_text_is_left_rather_than_read_beyond_it) {
  EXPECT_EQ(read_word("1.5", ""), std::nullopt);
  EXPECT_EQ(read_word("1.5", "12345.6 ", ""), std::nullopt);
  EXPECT_EQ(read_word("1.5", "1234 ", " 1234"), 1.5);
}

}  // namespace keyblock::formats::plain_real_test
