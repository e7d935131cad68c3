// Reads the most common numbers of files, digits and a point, eight characters at a time.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace keyblock::formats {
namespace plain {

inline constexpr std::array<double, 9> kPowersOfTen{1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8};
inline constexpr std::uint64_t kZeros = 0x3030303030303030;  // eight digits 0

/// Loads eight characters as one number, the first of them lowest.
inline std::uint64_t eight_characters(const char* at) {
  std::uint64_t eight = 0;
  std::memcpy(&eight, at, sizeof eight);
  if constexpr (std::endian::native == std::endian::big) eight = __builtin_bswap64(eight);
  return eight;
}

/// Returns a number with non-zero bits in each of eight characters that is not a digit. Digits have 3 as upper half,
/// also after 6 is added. A carry from a non-digit reaches only later characters.
constexpr std::uint64_t no_digits(std::uint64_t eight) {
  constexpr std::uint64_t kUpper = 0xF0F0F0F0F0F0F0F0, kSix = 0x0606060606060606;
  return ((eight & kUpper) ^ kZeros) | (((eight + kSix) & kUpper) ^ kZeros);
}

/// Returns the value of eight digits: neighbours are joined to pairs, pairs to fours, fours to the whole, in all lanes
/// at once. A byte of zeros counts as digit 0.
constexpr std::uint64_t value_of(std::uint64_t digits) {
  std::uint64_t lanes = digits & 0x0F0F0F0F0F0F0F0F;
  lanes = ((lanes * (1 + (10 << 8))) >> 8) & 0x00FF00FF00FF00FF;
  lanes = ((lanes * (1 + (100 << 16))) >> 16) & 0x0000FFFF0000FFFF;
  return (lanes * (1 + (std::uint64_t{10000} << 32))) >> 32;
}

/// Converts a number below 2⁵³; the processor has no conversion for unsigned numbers.
constexpr double as_double(std::uint64_t whole) {
  return static_cast<double>(static_cast<std::int64_t>(whole));
}

}  // namespace plain

/// Reads the word of a text from `first` to `last`, which is not empty and has no digit after it. It accepts plain
/// numbers of usual length: 1 to 7 digits, and optionally a point and 1 to 8 digits. The result has the same bits as
/// that of `parse_real`, and is several times faster. Returns false and writes nothing for other words and for some
/// near the ends of the text.
///
/// One rounding of two exact doubles gives the nearest double (Clinger 1990, How to read floating point numbers
/// accurately).
inline bool read_plain_real(std::string_view text, std::size_t first, std::size_t last, double& value) {
  const bool is_negative = text[first] == '-';
  if (is_negative || text[first] == '+') ++first;
  if (last < 8 || text.size() - first < 8) return false;
  const std::uint64_t head = plain::eight_characters(text.data() + first);
  const auto before = static_cast<std::size_t>(std::countr_zero(plain::no_digits(head))) / 8;
  if (before == 0 || before == 8) return false;
  double size = plain::as_double(plain::value_of(head << (64 - 8 * before)));
  if (const std::size_t point = first + before; point != last) {
    const std::size_t behind = last - point - 1;
    if (text[point] != '.' || behind == 0 || behind > 8) return false;
    const std::uint64_t others = (std::uint64_t{1} << (64 - 8 * behind)) - 1;  // characters up to the point
    const std::uint64_t tail = (plain::eight_characters(text.data() + last - 8) & ~others) | (plain::kZeros & others);
    if (plain::no_digits(tail) != 0) return false;
    const double power = plain::kPowersOfTen[behind];
    size = (size * power + plain::as_double(plain::value_of(tail))) / power;  // below 10¹⁵: exact up to the division
  }
  value = is_negative ? -size : size;
  return true;
}

}  // namespace keyblock::formats
