// Splitting of text into words, and the cursor that names what it expected and what it found.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/tokens.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "formats/numbers.hpp"

namespace keyblock::formats {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr char kDosEndOfFile = 0x1a;
constexpr std::size_t kLongestQuote = 40;  // of an unexpected word in a message
constexpr std::size_t kWordsAMark = 32;    // of a list of tokens
constexpr std::size_t kStretch = 256;      // of text between two marks of its map

bool is_line_end(char c) {
  return c == '\n' || c == '\r';
}

/// What a character does between words. A slash is ordinary but where a second follows.
enum class Role : unsigned char { ordinary, separator, comment, slash };
using Roles = std::array<Role, 256>;

constexpr Roles roles_of(Syntax syntax) {
  Roles roles{};
  const auto set = [&](std::string_view characters, Role role) {
    for (const char c : characters) roles[static_cast<unsigned char>(c)] = role;
  };
  set(" \t,\v\f\n\r", Role::separator);
  roles[kDosEndOfFile] = Role::separator;
  if (syntax == Syntax::xml) {
    set(";", Role::separator);
    roles[0] = Role::separator;  // the XML reader ends each piece so, in place
  } else {
    set("#%!;", Role::comment);
    set("/", Role::slash);
  }
  return roles;
}

constexpr Roles kNativeRoles = roles_of(Syntax::native);
constexpr Roles kXmlRoles = roles_of(Syntax::xml);
constexpr Roles kRunRoles = [] {
  Roles roles = kNativeRoles;
  roles[','] = Role::ordinary;
  return roles;
}();

/// Finds the words of a text one after another.
class Splitter {
 public:
  Splitter(std::string_view text, Syntax syntax) : Splitter(text, syntax == Syntax::xml ? kXmlRoles : kNativeRoles) {}
  Splitter(std::string_view text, const Roles& roles) : text_(text), roles_(roles) {}

  /// The start of the first word from `at` on; the end of the text where there is none.
  std::size_t word_start(std::size_t at) const {
    for (; at < text_.size(); ++at) {
      const Role role = role_at(at);
      if (role == Role::ordinary) return at;
      if (role != Role::comment) continue;
      while (at + 1 < text_.size() && !is_line_end(text_[at + 1])) ++at;
    }
    return at;
  }

  bool is_end(std::size_t at) const { return at == text_.size() || role_at(at) != Role::ordinary; }

  std::size_t word_end(std::size_t at) const {
    while (!is_end(at)) ++at;
    return at;
  }

  std::string_view text() const { return text_; }

 private:
  Role role_at(std::size_t at) const {
    const Role role = roles_[static_cast<unsigned char>(text_[at])];
    if (role != Role::slash) return role;
    return at + 1 < text_.size() && text_[at + 1] == '/' ? Role::comment : Role::ordinary;
  }

  std::string_view text_;
  const Roles& roles_;
};

bool may_part_words(char c) {
  return static_cast<unsigned char>(c) <= ' ' || c == ',' || c == ';';
}

/// No fewer than the words in a text: every word begins it or follows a separator.
std::size_t most_words(std::string_view text) {
  std::size_t count = text.empty() ? 0 : 1;
  for (std::size_t i = 1; i < text.size(); ++i)
    count += may_part_words(text[i - 1]) && !may_part_words(text[i]) ? 1 : 0;
  return count;
}

/// Counts a word; every so many-th, and the first of a piece, is marked.
void add_word(Tokens& tokens, std::size_t at, bool is_first) {
  if (is_first || tokens.word_count - tokens.marks.back().word == kWordsAMark)
    tokens.marks.push_back({tokens.word_count, at});
  ++tokens.word_count;
}

/// Adds words from `at` on as long as they are numbers, and the first that is none; the start of the word behind.
std::size_t add_numbers(Tokens& tokens, const Splitter& splitter, std::size_t at) {
  const std::string_view text = splitter.text();
  const char* const begin = text.data();
  for (bool is_first = true; at < text.size(); is_first = false) {
    add_word(tokens, at, is_first);
    const ShortReal number = parse_short_real(begin + at, begin + text.size());
    if (number.end && splitter.is_end(static_cast<std::size_t>(number.end - begin))) {
      tokens.numbers.push_back(number.value);
      at = splitter.word_start(static_cast<std::size_t>(number.end - begin));
      continue;
    }
    const std::size_t end = splitter.word_end(at);
    const auto value = parse_real(text.substr(at, end - at));
    at = splitter.word_start(end);
    if (!value) break;
    tokens.numbers.push_back(*value);
  }
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

TextMap::Mark TextMap::advanced(Mark mark, std::size_t first, std::size_t last) const {
  for (std::size_t i = first; i < last; ++i) {
    const bool ends_line = text_[i] == '\n' || (text_[i] == '\r' && (i + 1 == text_.size() || text_[i + 1] != '\n'));
    if (ends_line) mark = {mark.line + 1, i + 1};
  }
  return mark;
}

Place TextMap::place(std::size_t offset) const {
  const std::size_t at = std::min(offset, text_.size());
  if (marks_.empty()) marks_.push_back({1, 0});
  while (marks_.size() <= at / kStretch) {
    const std::size_t begin = (marks_.size() - 1) * kStretch;
    marks_.push_back(advanced(marks_.back(), begin, begin + kStretch));
  }
  const Mark mark = advanced(marks_[at / kStretch], at / kStretch * kStretch, at);
  return {file_, static_cast<int>(mark.line), static_cast<int>(at - mark.line_start + 1)};
}

std::string_view without_bom(std::string_view text) {
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  return text;
}

std::size_t Tokens::start_of(std::size_t index) const {
  const auto after = std::ranges::upper_bound(marks, index, {}, &Mark::word);
  const Splitter splitter(text, syntax);
  std::size_t at = std::prev(after)->offset;
  for (std::size_t i = std::prev(after)->word; i < index; ++i) at = splitter.word_start(splitter.word_end(at));
  return at;
}

std::string_view Tokens::word(std::size_t index) const {
  const std::size_t start = start_of(index);
  return text.substr(start, Splitter(text, syntax).word_end(start) - start);
}

std::optional<std::string_view> Tokens::junk() const {
  if (numbers.size() == word_count) return std::nullopt;
  return word(numbers.size());
}

Place Tokens::place_of(std::size_t index) const {
  return map->place(index < word_count ? start_of(index) : end);
}

Tokens tokenise(const Source& source) {
  const std::string_view text = without_bom(source.text);
  Tokens tokens{std::make_shared<TextMap>(source.name, text), text, Syntax::native, text.size()};
  add_words(tokens, 0, text.size());
  return tokens;
}

void add_words(Tokens& tokens, std::size_t first, std::size_t size) {
  const std::string_view text = tokens.text.substr(0, first + size);
  if (tokens.word_count == 0)  // a list that grows by doubling would hold thrice as much for a moment
    tokens.numbers.reserve(most_words(text.substr(first)));
  const Splitter splitter(text, tokens.syntax);
  const std::size_t words_before = tokens.word_count;
  std::size_t at = splitter.word_start(first);
  if (tokens.numbers.size() == tokens.word_count) at = add_numbers(tokens, splitter, at);
  for (; at < text.size(); at = splitter.word_start(splitter.word_end(at)))
    add_word(tokens, at, tokens.word_count == words_before);
}

std::string_view next_run(std::string_view text, std::size_t at) {
  const Splitter splitter(text, kRunRoles);
  const std::size_t start = splitter.word_start(at);
  return text.substr(start, splitter.word_end(start) - start);
}

std::string Cursor::full_name(std::string_view name) const {
  if (!record_) return std::string(name);
  if (record_->number == 0) return fmt::format("{} of {}", name, record_->noun);
  return fmt::format("{} of {} {} of {}", name, record_->noun, record_->number, record_->of);
}

std::string Cursor::found() const {
  return at_end() ? std::string(end_name_) : in_quotes(tokens_.word(position_));
}

void Cursor::fail(std::string_view expected) const {
  throw InputError(place(), fmt::format("expected {}, found {}", expected, found()));
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

void Cursor::fail_whole(std::string_view name) const {
  fail(fmt::format("{} (a whole number)", full_name(name)));
}

int Cursor::next_integer(std::string_view name, const Demand& demand) {
  if (numbers_left() > 0 && !demand.holds(tokens_.numbers[position_]))
    fail(fmt::format("{} ({})", full_name(name), demand.wording));
  return next_integer(name);
}

void Cursor::fail_between(int least, int most, std::string_view name) const {
  fail(fmt::format("{} (a whole number from {} to {})", full_name(name), least, most));
}

int Cursor::next_count(std::string_view name) {
  if (numbers_left() == 0) fail(full_name(name));
  const double value = tokens_.numbers[position_];
  const std::size_t following = tokens_.word_count - position_ - 1;
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
                        fmt::format("text from {} on is ignored", in_quotes(*junk))});
  return warnings;
}

}  // namespace keyblock::formats
