// Cuts a text at line ends into parts, one per thread; joins their words as if one thread had found all.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/text/split.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <memory>

#include "base/large_pages.hpp"
#include "base/parallel.hpp"
#include "formats/text/numbers.hpp"
#include "formats/text/plain_real.hpp"
#include "formats/text/word_bits.hpp"

namespace keyblock::formats {
namespace {

constexpr std::size_t kWordsAMark = 32;

/// Part of a text and its words, as one thread finds them.
struct Part {
  std::size_t first = 0;
  std::size_t last = 0;
  std::vector<std::uint64_t> bits = {};
  std::size_t word_count = 0;
  std::vector<Tokens::Mark> marks = {};  ///< words counted from the first of this part
  double* numbers = nullptr;             ///< space for one number per word; null if none are required
  std::size_t number_count = 0;          ///< of the leading words that are numbers
};

/// Converts a word to `value`; returns false if it is not a number.
bool read_number(std::string_view text, std::size_t first, std::size_t last, double& value) {
  if (read_plain_real(text, first, last, value)) return true;
  const auto number = parse_real(text.substr(first, last - first));
  if (number) value = *number;
  return number.has_value();
}

/// Passes each word of a part to `take`: its first character and the one after its last.
template <typename Take>
void for_each_word(const Part& part, Take take) {
  std::array<std::size_t, kBlock + 1> edges{};  // starts and ends of words, alternately
  std::size_t count = 0;
  std::uint64_t before = 0;
  for (std::size_t i = 0; i < part.bits.size(); ++i) {
    for (std::uint64_t bits = edge_bits(part.bits[i], before); bits != 0; bits &= bits - 1)
      edges[count++] = part.first + kBlock * i + static_cast<std::size_t>(std::countr_zero(bits));
    before = part.bits[i];
    std::size_t k = 0;
    for (; k + 1 < count; k += 2) take(edges[k], edges[k + 1]);
    if (k < count) edges[0] = edges[k];  // this word continues in the next block
    count -= k;
  }
  if (count > 0) take(edges[0], part.last);
}

void find_words(Part& part, std::string_view text) {
  std::size_t words = 0;
  double* number = part.numbers;
  bool is_number = number != nullptr;
  part.marks.reserve(part.word_count / kWordsAMark + 1);
  for_each_word(part, [&](std::size_t first, std::size_t last) {
    if (words++ % kWordsAMark == 0) part.marks.push_back({words - 1, first});
    is_number = is_number && read_number(text, first, last, *number);
    number += is_number ? 1 : 0;
  });
  part.number_count = static_cast<std::size_t>(number - part.numbers);
}

/// Returns up to `count` parts of about the same length. Each except the first begins after a line end, where no word
/// and no comment continues.
std::vector<Part> parts_of(std::string_view text, std::size_t first, std::size_t last, std::size_t count) {
  std::vector<Part> parts;
  const std::size_t length = (last - first) / count + 1;
  while (first < last) {
    std::size_t end = std::min(first + length, last);
    while (end < last && !is_line_end(text[end - 1])) ++end;
    parts.push_back({first, end});
    first = end;
  }
  return parts;
}

/// Appends the words and numbers of a part, in order; numbers only if no other word precedes them. If all words are
/// numbers, they are in place already.
void join(Tokens& tokens, const Part& part, std::size_t& number_count) {
  for (const Tokens::Mark& mark : part.marks) tokens.marks.push_back({tokens.word_count + mark.word, mark.offset});
  if (number_count == tokens.word_count) number_count += part.number_count;
  tokens.word_count += part.word_count;
}

/// Reserves space for the numbers of each part after the existing ones; none if those have ended.
void make_room(Tokens& tokens, std::vector<Part>& parts) {
  std::size_t count = tokens.numbers.size();
  if (count < tokens.word_count) return;
  std::size_t room = count;
  for (const Part& part : parts) room += part.word_count;
  if (count == 0) reserve_large(tokens.numbers, room);
  tokens.numbers.resize(room);
  for (Part& part : parts) {
    part.numbers = tokens.numbers.data() + count;
    count += part.word_count;
  }
}

void add_parts(Tokens& tokens, std::vector<Part> parts) {
  std::size_t number_count = tokens.numbers.size();
  at_once(parts.size(), [&](std::size_t i) {
    Part& part = parts[i];
    part.bits = word_bits(tokens.text.substr(part.first, part.last - part.first), tokens.syntax);
    part.word_count = count_words(part.bits);
  });
  make_room(tokens, parts);
  at_once(parts.size(), [&](std::size_t i) { find_words(parts[i], tokens.text); });
  for (const Part& part : parts) join(tokens, part, number_count);
  tokens.numbers.resize(number_count);
}

}  // namespace

Tokens tokenise(const Source& source, std::size_t threads) {
  const std::string_view text = without_bom(source.text);
  Tokens tokens{std::make_shared<TextMap>(source.name, text), text, Syntax::native, text.size()};
  add_parts(tokens, parts_of(text, 0, text.size(), threads > 0 ? threads : threads_for_bytes(text.size())));
  return tokens;
}

void add_words(Tokens& tokens, std::size_t first, std::size_t size) {
  add_parts(tokens, parts_of(tokens.text, first, first + size, 1));
}

}  // namespace keyblock::formats
