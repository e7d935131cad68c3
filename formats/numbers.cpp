// Locale-free conversion of reals through std::from_chars and std::to_chars.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/numbers.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace keyblock::formats {

namespace {

constexpr int kMostDigits = 19;                                   // that 64 bits always hold
constexpr std::uint64_t kGreatestExact = std::uint64_t{1} << 53;  // up to which every whole number is a double
constexpr std::array<double, 23> kPowersOfTen{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                              1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

/// Adds the digits from `at` on to `whole`, which may overflow; the first other character.
const char* add_digits(const char* at, const char* last, std::uint64_t& whole) {
  for (; at != last; ++at) {
    const auto digit = static_cast<unsigned>(*at) - '0';
    if (digit > 9) break;
    whole = 10 * whole + digit;
  }
  return at;
}

/// Behind an `e`: sign and one to three digits; null where they are not there.
const char* add_exponent(const char* at, const char* last, int& exponent) {
  const bool is_negative = at != last && *at == '-';
  if (at != last && (*at == '-' || *at == '+')) ++at;
  std::uint64_t digits = 0;
  const char* const end = add_digits(at, last, digits);
  if (end == at || end - at > 3) return nullptr;
  exponent += is_negative ? -static_cast<int>(digits) : static_cast<int>(digits);
  return end;
}

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

// One rounding of two exact doubles gives the nearest double (Clinger 1990, How to read floating point numbers accurately).
ShortReal parse_short_real(const char* at, const char* last) {
  if (at == last) return {};
  const bool is_negative = *at == '-';
  if (*at == '-' || *at == '+') ++at;
  std::uint64_t whole = 0;
  const char* const first = at;
  at = add_digits(at, last, whole);
  auto digits = at - first;
  int exponent = 0;
  if (at != last && *at == '.') {
    const char* const fraction = ++at;
    at = add_digits(at, last, whole);
    exponent = static_cast<int>(fraction - at);
    digits += at - fraction;
  }
  if (digits == 0 || digits > kMostDigits || whole > kGreatestExact) return {};
  if (at != last && (*at == 'e' || *at == 'E')) {
    at = add_exponent(at + 1, last, exponent);
    if (!at) return {};
  }
  if (exponent < -22 || exponent > 22) return {};
  auto value = static_cast<double>(static_cast<std::int64_t>(whole));
  if (exponent < 0)
    value /= kPowersOfTen[static_cast<std::size_t>(-exponent)];
  else if (exponent > 0)
    value *= kPowersOfTen[static_cast<std::size_t>(exponent)];
  return {is_negative ? -value : value, at};
}

}  // namespace keyblock::formats
