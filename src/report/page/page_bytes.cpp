// Codes numbers of a page; see page_bytes.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/page/page_bytes.hpp"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "report/drawing/png.hpp"

namespace keyblock::report {
namespace {

constexpr int kFractionBits = 23;
constexpr double kSmallest = 1e-30;
constexpr int kLevel = 6;  // of zlib

}  // namespace

std::uint32_t rounded_bits(double value, int bits) {
  constexpr auto kLargest = static_cast<double>(std::numeric_limits<float>::max());
  if (std::isnan(value)) return std::bit_cast<std::uint32_t>(std::numeric_limits<float>::quiet_NaN());
  if (std::abs(value) < kSmallest) return 0;
  const auto word = std::bit_cast<std::uint32_t>(static_cast<float>(std::clamp(value, -kLargest, kLargest)));
  const int dropped = kFractionBits - bits;
  if (dropped <= 0) return word;
  const std::uint32_t mask = (1U << dropped) - 1;
  const std::uint32_t up = (word + (1U << (dropped - 1))) & ~mask;
  return std::isfinite(std::bit_cast<float>(up)) ? up : word & ~mask;
}

void subtract_rows(std::span<std::uint32_t> words, std::size_t row) {
  for (std::size_t i = words.size(); i > row; --i) words[i - 1] ^= words[i - 1 - row];
}

std::string byte_planes(std::span<const std::uint32_t> words) {
  std::string bytes(4 * words.size(), '\0');
  for (std::size_t plane = 0; plane < 4; ++plane)
    for (std::size_t i = 0; i < words.size(); ++i)
      bytes[plane * words.size() + i] = static_cast<char>(words[i] >> (8 * plane) & 0xff);
  return bytes;
}

std::string little_endian(std::span<const std::uint32_t> words) {
  std::string bytes;
  bytes.reserve(4 * words.size());
  for (const std::uint32_t word : words)
    for (int byte = 0; byte < 4; ++byte) bytes += static_cast<char>(word >> (8 * byte) & 0xff);
  return bytes;
}

std::string packed_text(const std::string& bytes) {
  uLongf size = compressBound(bytes.size());
  std::string packed(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                bytes.size(), kLevel) != Z_OK)
    throw std::runtime_error("zlib cannot pack the page");
  packed.resize(size);
  return base64(packed);
}

}  // namespace keyblock::report
