// Words know their place with any line endings, and a cursor reports the expected word and its place.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/text/tokens.hpp"

#include <gtest/gtest.h>

#include "formats/text/split.hpp"

namespace keyblock::formats::tokens_test {
namespace {

Tokens tokens_of(const std::string& text) {
  static Source source;  // tokens view it
  source = {"f", text};
  return tokenise(source);
}

template <typename Action>
std::string message(Action action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

}  // namespace

TEST(Tokens, white_space_and_commas_separate_and_comments_end_with_their_line) {
  const Tokens tokens = tokens_of("1,2\t3 # four 4\n5 % 6\n7!8\r\n9;10\n11//12\n13");
  EXPECT_EQ(tokens.numbers, (Numbers{1, 2, 3, 5, 7, 9, 11, 13}));
}

TEST(Tokens, lines_count_alike_for_every_kind_of_line_end) {
  for (const char* text : {"1\n2\n 3", "1\r\n2\r\n 3", "1\r2\r 3"})
    EXPECT_EQ(tokens_of(text).place_of(2), (Place{"f", 3, 2})) << text;
}

TEST(Tokens, every_word_of_a_long_text_knows_its_place_in_any_order) {
  std::string text;
  std::vector<Place> places;
  for (int line = 1; line <= 400; ++line) {
    text += std::string(static_cast<std::size_t>(line % 7), ' ');
    for (int i = 0, column = line % 7 + 1; i < line % 5; ++i, column += 5) {
      places.push_back({"f", line, column});
      text += i % 2 == 0 ? "12.5 " : "-777,";
    }
    text += "# a comment 1 2\n";
  }
  const Tokens tokens = tokens_of(text);
  ASSERT_EQ(tokens.word_count, places.size());
  for (std::size_t i = places.size(); i-- > 0;) EXPECT_EQ(tokens.place_of(i), places[i]) << i;
}

TEST(Tokens, byte_order_mark_is_no_column) {
  EXPECT_EQ(tokens_of("\xEF\xBB\xBF"
                      "7")
                .place_of(0),
            (Place{"f", 1, 1}));
}

TEST(Tokens, what_follows_the_leading_numbers_is_junk_with_its_place) {
  const Tokens tokens = tokens_of("1 2\npen=0.1*g0;%contact force penalty");
  ASSERT_TRUE(tokens.junk());
  EXPECT_EQ(*tokens.junk(), "pen=0.1*g0");
  EXPECT_EQ(tokens.place_of(2), (Place{"f", 2, 1}));
}

TEST(Tokens, not_a_number_and_infinity_end_the_numbers) {
  EXPECT_EQ(tokens_of("1 nan 2").numbers.size(), 1u);
  EXPECT_EQ(tokens_of("1 inf 2").numbers.size(), 1u);
}

TEST(Tokens, dos_end_of_file_mark_separates) {
  EXPECT_EQ(tokens_of("1 2\x1a").numbers.size(), 2u);
}

TEST(Cursor, names_the_token_the_record_and_what_was_found) {
  const Tokens tokens = tokens_of("1 abc");
  Cursor cursor(tokens);
  cursor.enter({"line", 3, 30});
  EXPECT_EQ(cursor.next_real("x of the start"), 1);
  EXPECT_EQ(message([&] { cursor.next_real("y of the start"); }),
            "f:1:3: error: expected y of the start of line 3 of 30, found \"abc\"");
}

TEST(Cursor, end_of_the_file_is_found_where_the_text_ends) {
  const Tokens tokens = tokens_of("1\n2 ");
  Cursor cursor(tokens);
  cursor.next_real("a");
  cursor.next_real("b");
  EXPECT_EQ(message([&] { cursor.next_real("c"); }), "f:2:3: error: expected c, found end of file");
}

TEST(Cursor, count_greater_than_what_follows_is_refused_before_anything_is_made) {
  const Tokens tokens = tokens_of("1000000000 1 2");
  EXPECT_EQ(message([&] { Cursor(tokens).next_count("the number of lines"); }),
            "f:1:1: error: expected the number of lines (at most 2: so many values follow), found \"1000000000\"");
}

TEST(Cursor, counts_are_whole_and_not_negative) {
  for (const char* text : {"-1", "0.5", "1e300", "-1e300"}) {
    const Tokens tokens = tokens_of(text);
    EXPECT_NE(message([&] { Cursor(tokens).next_count("n"); }), "") << text;
  }
  const Tokens tokens = tokens_of("2.000 1 1");
  EXPECT_EQ(Cursor(tokens).next_count("n"), 2);
}

TEST(Cursor, unprintable_words_are_quoted_readably) {
  const Tokens tokens = tokens_of(std::string("\x01", 1) + std::string(100, 'x'));
  EXPECT_EQ(message([&] { Cursor(tokens).next_real("a"); }),
            "f:1:1: error: expected a, found \"\\x01" + std::string(39, 'x') + "…\"");
}

}  // namespace keyblock::formats::tokens_test
