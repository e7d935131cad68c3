// Judges each run of characters without white space that contains a comma.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/text/decimal_comma.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace keyblock::formats {
namespace {

constexpr std::string_view kTenDigits = "0123456789";
constexpr std::size_t kGroup = 3;  // digits of a group of thousands

std::size_t leading_digits(std::string_view text) {
  return std::min(text.find_first_not_of(kTenDigits), text.size());
}

bool drop_one_of(std::string_view& text, std::string_view characters) {
  const bool has = !text.empty() && characters.find(text.front()) != std::string_view::npos;
  if (has) text.remove_prefix(1);
  return has;
}

/// Drops digits, perhaps with groups of thousands after `group`. There may be no digits, as in `,5`.
void drop_whole_part(std::string_view& text, char group) {
  const std::size_t first = leading_digits(text);
  const bool may_be_grouped = first > 0 && first <= kGroup && text.front() != '0';
  text.remove_prefix(first);
  while (may_be_grouped && text.starts_with(group) && leading_digits(text.substr(1)) == kGroup)
    text.remove_prefix(1 + kGroup);
}

/// Returns true if the whole text is one number with these characters as group separator and decimal point.
bool is_one_number(std::string_view text, char group, char point) {
  drop_one_of(text, "+-");
  drop_whole_part(text, group);
  if (text.starts_with(point)) {
    const std::size_t digits = leading_digits(text.substr(1));
    if (digits == 0) return false;
    text.remove_prefix(1 + digits);
  }
  if (drop_one_of(text, "eEdD")) {
    drop_one_of(text, "+-");
    if (leading_digits(text) == 0) return false;
    text.remove_prefix(leading_digits(text));
  }
  return text.empty();
}

enum class Commas { none, beside_space, either, parting };

Commas commas_in(std::string_view run) {
  if (run.find(',') == std::string_view::npos) return Commas::none;
  run = run.substr(0, run.find_last_not_of(',') + 1);
  if (run.find(',') == std::string_view::npos) return Commas::beside_space;
  return is_one_number(run, '.', ',') || is_one_number(run, ',', '.') ? Commas::either : Commas::parting;
}

/// Returns true if only white space separates numbers on a line with a number whose comma may be decimal.
bool mix(Commas a, Commas b) {
  return (a == Commas::either && b == Commas::none) || (a == Commas::none && b == Commas::either);
}

/// Returns the first run whose commas may be part of a number; empty if they are known to separate numbers.
std::string_view find_doubtful(std::string_view text) {
  std::string_view doubtful;
  bool commas_part = false;
  Commas before = Commas::beside_space;
  std::size_t end_before = 0;
  for (std::string_view run = next_run(text, 0); !run.empty(); run = next_run(text, end_before)) {
    const auto start = static_cast<std::size_t>(run.data() - text.data());
    const Commas commas = commas_in(run);
    const bool is_same_line =
        text.substr(end_before, start - end_before).find_first_of("\r\n") == std::string_view::npos;
    if (commas == Commas::either && doubtful.empty()) doubtful = run;
    if (is_same_line && mix(before, commas)) return doubtful;
    commas_part = commas_part || commas == Commas::parting;
    before = commas;
    end_before = start + run.size();
  }
  return commas_part ? std::string_view{} : doubtful;
}

}  // namespace

void refuse_decimal_commas(const TextMap& map, std::string_view text, std::size_t first, std::size_t size) {
  const std::string_view part = text.substr(first, size);
  if (part.find(',') == std::string_view::npos) return;
  const std::string_view run = find_doubtful(part);
  if (run.empty()) return;
  const auto comma = static_cast<std::size_t>(run.data() - text.data()) + run.find(',');
  throw InputError(
      map.place(comma),
      fmt::format("expected a decimal point, or white space beside a comma that parts two numbers, found {}",
                  in_quotes(run)));
}

void refuse_decimal_commas(const Tokens& tokens) {
  const std::size_t end = tokens.junk() ? tokens.start_of(tokens.numbers.size()) : tokens.text.size();
  refuse_decimal_commas(*tokens.map, tokens.text, 0, end);
}

}  // namespace keyblock::formats
