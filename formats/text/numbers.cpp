// Converts reals independently of the locale, by std::from_chars and std::to_chars.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/text/numbers.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace keyblock::formats {

namespace {

std::optional<double> plain_real(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace

void append_real(std::string& text, double value) {
  std::array<char, 32> digits;
  text.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr);
}

void append_integer(std::string& text, int value) {
  std::array<char, 12> digits;
  text.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr);
}

std::string format_real(double value) {
  std::array<char, 32> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

void append_rounded(std::string& text, double value) {
  std::array<char, 32> digits;
  const auto end =
      std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::general, 12).ptr;
  text.append(digits.data(), end);
}

std::optional<double> parse_real(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  if (text.empty() || text.size() > 400 || text.starts_with('+')) return std::nullopt;
  if (const auto value = plain_real(text)) return value;
  const std::size_t mark = text.find_first_of("dD");
  if (mark == std::string_view::npos) return std::nullopt;
  std::string plain(text);
  plain[mark] = 'e';
  return plain_real(plain);
}

}  // namespace keyblock::formats
