// Locale-free conversion of reals through std::from_chars and std::to_chars.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/numbers.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace keyblock::formats {

std::string format_real(double value) {
  std::array<char, 32> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

std::optional<double> parse_real(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  if (text.empty() || text.size() > 400 || text.starts_with('+')) return std::nullopt;
  std::string plain(text);
  std::ranges::replace_if(
      plain, [](char c) { return c == 'd' || c == 'D'; }, 'e');
  double value = 0;
  const auto [end, error] = std::from_chars(plain.data(), plain.data() + plain.size(), value);
  if (error != std::errc{} || end != plain.data() + plain.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace keyblock::formats
