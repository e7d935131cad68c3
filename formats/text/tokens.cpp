// Finds the places of words, and reads tokens with messages that name the expected and the found text.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/text/tokens.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/printable.hpp"
#include "base/sentences/sentences.hpp"
#include "formats/text/numbers.hpp"

namespace keyblock::formats {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr std::size_t kLongestQuote = 40;  // longest quote of an unexpected word in a message
constexpr std::size_t kStretch = 256;      // length of text between two marks of its map

constexpr Roles kRunRoles = [] {
  Roles roles = kNativeRoles;
  roles[','] = Role::ordinary;
  return roles;
}();

}  // namespace

std::string in_quotes(std::string_view word) {
  return '"' + printable(word.substr(0, kLongestQuote)) + (word.size() > kLongestQuote ? "…\"" : "\"");
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
  const std::scoped_lock lock(guard_);
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
  if (numbers_left() > 0) warnings.push_back(warning_of({"surplus_numbers", {{{"count", numbers_left()}}}}, place()));
  if (const auto junk = tokens_.junk()) {
    Facts facts{{}, {{"quoted", in_quotes(*junk)}}};
    facts.names = {{"text", std::string(*junk)}};
    warnings.push_back(warning_of({"trailing_text", std::move(facts)}, tokens_.place_of(tokens_.numbers.size())));
  }
  return warnings;
}

}  // namespace keyblock::formats
