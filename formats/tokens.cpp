// Splitting of text into words, and the cursor that names what it expected and what it found.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/tokens.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "formats/numbers.hpp"

namespace keyblock::formats {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr char kDosEndOfFile = 0x1a;
constexpr std::size_t kLongestQuote = 40;  // of an unexpected word in a message
constexpr double kGreatestInteger = 2147483647;

bool is_line_end(char c) {
  return c == '\n' || c == '\r';
}

bool is_separator(char c, Syntax syntax) {
  return c == ' ' || c == '\t' || c == ',' || c == kDosEndOfFile || c == '\v' || c == '\f' || is_line_end(c) ||
         (syntax == Syntax::xml && c == ';');
}

bool starts_comment(std::string_view rest, Syntax syntax) {
  if (syntax == Syntax::xml) return false;
  return std::string_view("#%!;").find(rest.front()) != std::string_view::npos || rest.starts_with("//");
}

std::size_t skip_line(std::string_view text, std::size_t at) {
  while (at < text.size() && !is_line_end(text[at])) ++at;
  return at;
}

std::size_t word_end(std::string_view text, std::size_t at, Syntax syntax) {
  while (at < text.size() && !is_separator(text[at], syntax) && !starts_comment(text.substr(at), syntax)) ++at;
  return at;
}

}  // namespace

std::string in_quotes(std::string_view word) {
  std::string text = "\"";
  for (const char c : word.substr(0, kLongestQuote)) {
    const auto byte = static_cast<unsigned char>(c);
    text += byte < 0x20 || byte == 0x7f ? fmt::format("\\x{:02x}", byte) : std::string(1, c);
  }
  return text + (word.size() > kLongestQuote ? "…\"" : "\"");
}

TextMap::TextMap(std::string file, std::string_view text) : file_(std::move(file)), size_(text.size()) {
  line_starts_.push_back(0);
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool ends_line = text[i] == '\n' || (text[i] == '\r' && (i + 1 == text.size() || text[i + 1] != '\n'));
    if (ends_line) line_starts_.push_back(i + 1);
  }
}

Place TextMap::place(std::size_t offset) const {
  const auto after = std::ranges::upper_bound(line_starts_, std::min(offset, size_));
  const auto line = after - line_starts_.begin();
  return {file_, static_cast<int>(line), static_cast<int>(std::min(offset, size_) - *std::prev(after) + 1)};
}

std::string_view without_bom(std::string_view text) {
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  return text;
}

std::vector<Word> split_words(std::string_view text, Syntax syntax, std::size_t first_offset) {
  std::vector<Word> words;
  std::size_t at = 0;
  while (at < text.size()) {
    if (is_separator(text[at], syntax)) {
      ++at;
    } else if (starts_comment(text.substr(at), syntax)) {
      at = skip_line(text, at);
    } else {
      const std::size_t end = word_end(text, at, syntax);
      words.push_back({text.substr(at, end - at), first_offset + at});
      at = end;
    }
  }
  return words;
}

std::optional<Word> Tokens::junk() const {
  if (numbers.size() == words.size()) return std::nullopt;
  return words[numbers.size()];
}

Place Tokens::place_of(std::size_t index) const {
  return map->place(index < words.size() ? words[index].offset : end);
}

Tokens tokenise(const Source& source) {
  const std::string_view text = without_bom(source.text);
  return tokenise_words(std::make_shared<TextMap>(source.name, text), split_words(text, Syntax::native), text.size());
}

Tokens tokenise_words(std::shared_ptr<const TextMap> map, std::vector<Word> words, std::size_t end) {
  Tokens tokens{std::move(map), std::move(words), {}, end};
  for (const Word& word : tokens.words) {
    const std::optional<double> value = parse_real(word.text);
    if (!value) break;
    tokens.numbers.push_back(*value);
  }
  return tokens;
}

bool is_whole(double value) {
  return std::abs(value) <= kGreatestInteger && value == std::floor(value);
}

std::string Cursor::full_name(std::string_view name) const {
  if (!record_) return std::string(name);
  if (record_->number == 0) return fmt::format("{} of {}", name, record_->noun);
  return fmt::format("{} of {} {} of {}", name, record_->noun, record_->number, record_->of);
}

std::string Cursor::found() const {
  return at_end() ? std::string(end_name_) : in_quotes(tokens_.words[position_].text);
}

void Cursor::fail(std::string_view expected) const {
  throw InputError(place(), fmt::format("expected {}, found {}", expected, found()));
}

double Cursor::next_real(std::string_view name) {
  if (numbers_left() == 0) fail(full_name(name));
  return tokens_.numbers[position_++];
}

double Cursor::next_real(std::string_view name, const Demand& demand) {
  if (numbers_left() > 0 && !demand.holds(tokens_.numbers[position_]))
    fail(fmt::format("{} ({})", full_name(name), demand.wording));
  return next_real(name);
}

double Cursor::next_real_above(double limit, std::string_view name) {
  if (numbers_left() > 0 && !(tokens_.numbers[position_] > limit))
    fail(fmt::format("{} (greater than {})", full_name(name), format_real(limit)));
  return next_real(name);
}

int Cursor::next_integer(std::string_view name) {
  if (numbers_left() > 0 && !is_whole(tokens_.numbers[position_]))
    fail(fmt::format("{} (a whole number)", full_name(name)));
  return static_cast<int>(next_real(name));
}

int Cursor::next_integer(std::string_view name, const Demand& demand) {
  if (numbers_left() > 0 && !demand.holds(tokens_.numbers[position_]))
    fail(fmt::format("{} ({})", full_name(name), demand.wording));
  return next_integer(name);
}

int Cursor::next_count(std::string_view name) {
  if (numbers_left() == 0) fail(full_name(name));
  const double value = tokens_.numbers[position_];
  const std::size_t following = tokens_.words.size() - position_ - 1;
  if (!is_whole(value) || value < 0) fail(fmt::format("{} (a whole number, 0 or more)", full_name(name)));
  if (value > static_cast<double>(following))
    fail(fmt::format("{} (at most {}: so many values follow)", full_name(name), following));
  return next_integer(name);
}

int Cursor::next_count_up_to(int limit, std::string_view whole, std::string_view name) {
  if (numbers_left() > 0 && tokens_.numbers[position_] > limit)
    fail(fmt::format("{} (at most {}, {})", full_name(name), limit, whole));
  return next_count(name);
}

Warnings Cursor::remainder() const {
  Warnings warnings;
  if (numbers_left() > 0)
    warnings.push_back(
        {"surplus_numbers", place(), fmt::format("{} numbers behind the last record are ignored", numbers_left())});
  if (const auto junk = tokens_.junk())
    warnings.push_back({"trailing_text", tokens_.place_of(tokens_.numbers.size()),
                        fmt::format("text from {} on is ignored", in_quotes(junk->text))});
  return warnings;
}

}  // namespace keyblock::formats
