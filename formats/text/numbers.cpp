// Converts reals independently of the locale: by std::from_chars and std::to_chars, and rounded ones by a faster way.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/text/numbers.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>

namespace keyblock::formats {

namespace {

std::optional<double> plain_real(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

constexpr int kDigits = 12;      // of a rounded number
constexpr double kLeast = 1e11;  // whole numbers of so many digits
constexpr double kBeyond = 1e12;
// All powers of ten that a double holds exactly.
constexpr std::array<double, 23> kPowers{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                         1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

/// A number as its rounded value and the rest, together exact to some 100 bits.
struct Scaled {
  double rounded;
  double rest;
};

/// Returns value · 10^power; `power` from -22 to 44.
Scaled scaled(double value, int power) {
  const auto ten_to = [](int exponent) { return kPowers[static_cast<std::size_t>(exponent)]; };
  if (power < 0) {
    const double quotient = value / ten_to(-power);
    return {quotient, std::fma(-quotient, ten_to(-power), value) / ten_to(-power)};
  }
  const double one = ten_to(std::min(power, 22)), other = ten_to(power - std::min(power, 22));
  const double factor = one * other;
  const double product = value * factor;
  return {product, std::fma(value, factor, -product) + value * std::fma(one, other, -factor)};
}

/// First twelve digits of a number, and the power of ten of the first.
struct Decimal {
  std::uint64_t digits;
  int exponent;
};

// Returns nothing beyond the range of `scaled`, and where the thirteenth digit does not decide.
std::optional<Decimal> decimal_of(double size) {
  constexpr double kUnclear = 1e-6;
  int exponent = std::ilogb(size) * 1233 >> 12;  // at most the exponent of ten, and at least one less
  for (;;) {
    if (std::abs(exponent) > 33) return std::nullopt;
    const auto [rounded, rest] = scaled(size, kDigits - 1 - exponent);
    const double whole = std::floor(rounded);
    const double part = rounded - whole + rest;
    if (std::abs(part - 0.5) < kUnclear) return std::nullopt;
    const double nearest = part > 0.5 ? whole + 1 : whole;
    if (nearest == kBeyond) return Decimal{static_cast<std::uint64_t>(kLeast), exponent + 1};
    if (nearest >= kLeast && nearest < kBeyond) return Decimal{static_cast<std::uint64_t>(nearest), exponent};
    exponent += nearest > kBeyond ? 1 : -1;
  }
}

/// Room for twelve digits and as many characters behind them, so that copies have one length.
using Digits = std::array<char, 32>;

Digits digits_of(std::uint64_t number) {
  static const auto pairs = [] {
    std::array<char, 200> text{};
    for (std::size_t i = 0; i < 100; ++i) {
      text[2 * i] = static_cast<char>('0' + i / 10);
      text[2 * i + 1] = static_cast<char>('0' + i % 10);
    }
    return text;
  }();
  constexpr std::size_t kHalf = kDigits / 2;
  Digits digits{};
  auto upper = static_cast<std::uint32_t>(number / 1'000'000);
  auto lower = static_cast<std::uint32_t>(number % 1'000'000);
  for (std::size_t i = kHalf; i > 0; i -= 2, upper /= 100, lower /= 100) {
    std::memcpy(digits.data() + i - 2, pairs.data() + 2 * (upper % 100), 2);
    std::memcpy(digits.data() + i - 2 + kHalf, pairs.data() + 2 * (lower % 100), 2);
  }
  return digits;
}

// Lays digits out as %g does: without zeros at the end, with an exponent below 1e-4 and from 1e12 on.
void append(std::string& text, bool is_negative, const Decimal& number) {
  constexpr std::size_t kCopied = 16;
  const Digits digits = digits_of(number.digits);
  std::size_t count = kDigits;
  while (count > 1 && digits[count - 1] == '0') --count;
  std::array<char, 48> out;
  out[0] = '-';
  char* const start = out.data() + 1;
  char* end = nullptr;
  if (number.exponent >= -4 && number.exponent < 0) {
    const auto zeros = static_cast<std::size_t>(-number.exponent);  // that before the point, and those behind it
    std::memcpy(start, "0.000", 5);
    std::memcpy(start + zeros + 1, digits.data(), kCopied);
    end = start + zeros + 1 + count;
  } else {
    const bool is_plain = number.exponent >= 0 && number.exponent < kDigits;
    const std::size_t whole = is_plain ? static_cast<std::size_t>(number.exponent) + 1 : 1;  // digits before the point
    std::memcpy(start, digits.data(), kCopied);
    start[whole] = '.';
    std::memcpy(start + whole + 1, digits.data() + whole, kCopied);
    end = start + (count > whole ? count + 1 : whole);
    if (!is_plain) {
      const int size = std::abs(number.exponent);
      *end++ = 'e';
      *end++ = number.exponent < 0 ? '-' : '+';
      *end++ = static_cast<char>('0' + size / 10);
      *end++ = static_cast<char>('0' + size % 10);
    }
  }
  const char* const from = is_negative ? out.data() : start;
  text.append(from, static_cast<std::size_t>(end - from));
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

// std::to_chars takes two and a half times as long. It decides ties, and writes 0 and numbers beyond the range of
// `scaled`.
void append_rounded(std::string& text, double value) {
  if (std::isnormal(value))
    if (const auto decimal = decimal_of(std::abs(value))) return append(text, value < 0, *decimal);
  std::array<char, 32> digits;
  const auto end =
      std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::general, kDigits).ptr;
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
