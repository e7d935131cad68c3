// A text split on several threads, 64 characters at a time, gives the words that one walk over it gives.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/text/split.hpp"

#include <gtest/gtest.h>

#include <random>

#include "formats/text/numbers.hpp"

namespace keyblock::formats::split_test {
namespace {

/// A text of words, separators of every kind and comments; `odd` in a hundred pieces are neither numbers nor white
/// space.
std::string some_text(std::mt19937& random, unsigned odd) {
  const auto one_of = [&](std::initializer_list<const char*> list) { return *(list.begin() + random() % list.size()); };
  std::string text;
  for (unsigned i = random() % 400; i > 0; --i) {
    text +=
        one_of({"1", "-2", "34567", "0.5", "+731.058500", "-40.142857", "12345678.25", "1e-3", "2.5d0", ".5", "7."});
    text += random() % 100 < odd
                ? one_of({"#", " % 5 ", "!", ";", "//", "/", " / ", "x", " nan ", "\x1a", "e", "\"", "\xff"})
                : one_of({" ", "\n", "\r\n", "\r", ",", "\t", "  ", " \n", "\v", "\f"});
  }
  return text;
}

struct Words {
  std::vector<std::size_t> starts;
  std::vector<double> numbers;
  bool operator==(const Words&) const = default;
};

Words words_one_by_one(const std::string& text, Syntax syntax) {
  const Splitter splitter(text, syntax);
  Words words;
  bool is_number = true;
  for (std::size_t at = splitter.word_start(0); at < text.size(); at = splitter.word_start(splitter.word_end(at))) {
    words.starts.push_back(at);
    const auto number = parse_real(std::string_view(text).substr(at, splitter.word_end(at) - at));
    is_number = is_number && number;
    if (is_number) words.numbers.push_back(*number);
  }
  return words;
}

Words words_of(const Tokens& tokens) {
  Words words{{}, {tokens.numbers.begin(), tokens.numbers.end()}};
  for (std::size_t i = 0; i < tokens.word_count; ++i) words.starts.push_back(tokens.start_of(i));
  return words;
}

}  // namespace

TEST(Split, any_text_gives_the_words_of_one_walk_for_any_number_of_threads) {
  std::mt19937 random(20010520);
  std::size_t numbers = 0, words = 0;
  for (int i = 0; i < 400; ++i) {
    const Source source{"f", some_text(random, static_cast<unsigned>(i % 5))};
    const Words expected = words_one_by_one(source.text, Syntax::native);
    numbers += expected.numbers.size();
    words += expected.starts.size();
    for (const std::size_t threads : {1, 2, 5})
      ASSERT_EQ(words_of(tokenise(source, threads)), expected) << threads << " threads: " << source.text;
  }
  EXPECT_GT(numbers, words / 4);
  EXPECT_LT(numbers, words);
}

TEST(Split, pieces_of_xml_give_the_words_of_one_walk) {
  std::mt19937 random(20010520);
  for (int i = 0; i < 1000; ++i) {
    const std::string first = some_text(random, 2), second = some_text(random, 2), text = first + " " + second;
    Tokens tokens{std::make_shared<TextMap>("f", text), text, Syntax::xml, text.size()};
    add_words(tokens, 0, first.size());
    add_words(tokens, first.size() + 1, second.size());
    ASSERT_EQ(words_of(tokens), words_one_by_one(text, Syntax::xml)) << text;
  }
}

TEST(Split, a_comment_longer_than_a_block_hides_its_words) {
  EXPECT_EQ(tokenise({"f", "1 #" + std::string(300, '2') + " 3\n4"}).numbers, (Numbers{1, 4}));
}

TEST(Split, a_word_longer_than_a_block_is_one_word) {
  const Source source{"f", "1 0." + std::string(200, '3') + " 2"};
  EXPECT_EQ(tokenise(source).numbers, (Numbers{1, 1 / 3., 2}));
}

}  // namespace keyblock::formats::split_test
