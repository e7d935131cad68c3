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
constexpr double kGreatestInteger = 2147483647;

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

/// Finds the words of a text one after another.
class Splitter {
 public:
  Splitter(std::string_view text, Syntax syntax)
      : text_(text), roles_(syntax == Syntax::xml ? kXmlRoles : kNativeRoles) {}

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

  std::size_t word_end(std::size_t at) const {
    while (at < text_.size() && role_at(at) == Role::ordinary) ++at;
    return at;
  }

 private:
  Role role_at(std::size_t at) const {
    const Role role = roles_[static_cast<unsigned char>(text_[at])];
    if (role != Role::slash) return role;
    return at + 1 < text_.size() && text_[at + 1] == '/' ? Role::comment : Role::ordinary;
  }

  std::string_view text_;
  const Roles& roles_;
};

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

std::string_view Tokens::word(std::size_t index) const {
  const std::size_t start = starts[index];
  return text.substr(start, Splitter(text, syntax).word_end(start) - start);
}

std::optional<std::string_view> Tokens::junk() const {
  if (numbers.size() == starts.size()) return std::nullopt;
  return word(numbers.size());
}

Place Tokens::place_of(std::size_t index) const {
  return map->place(index < starts.size() ? starts[index] : end);
}

Tokens tokenise(const Source& source) {
  const std::string_view text = without_bom(source.text);
  Tokens tokens{std::make_shared<TextMap>(source.name, text), text, Syntax::native, {}, {}, text.size()};
  add_words(tokens, 0, text.size());
  return tokens;
}

void add_words(Tokens& tokens, std::size_t first, std::size_t size) {
  const std::string_view text = tokens.text.substr(0, first + size);
  const Splitter splitter(text, tokens.syntax);
  for (std::size_t at = splitter.word_start(first); at < text.size();) {
    const std::size_t end = splitter.word_end(at);
    const bool is_behind_numbers_only = tokens.numbers.size() == tokens.starts.size();
    tokens.starts.push_back(at);
    if (is_behind_numbers_only)
      if (const auto value = parse_real(text.substr(at, end - at))) tokens.numbers.push_back(*value);
    at = splitter.word_start(end);
  }
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
  return at_end() ? std::string(end_name_) : in_quotes(tokens_.word(position_));
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

int Cursor::next_integer_between(int least, int most, std::string_view name) {
  const bool is_within = numbers_left() > 0 && is_whole(tokens_.numbers[position_]) &&
                         tokens_.numbers[position_] >= least && tokens_.numbers[position_] <= most;
  if (!is_within) fail(fmt::format("{} (a whole number from {} to {})", full_name(name), least, most));
  return next_integer(name);
}

int Cursor::next_count(std::string_view name) {
  if (numbers_left() == 0) fail(full_name(name));
  const double value = tokens_.numbers[position_];
  const std::size_t following = tokens_.starts.size() - position_ - 1;
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
