// Compares sixteen characters at once; a block with a letter, a comment sign or a control character takes the slow
// path.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/text/word_bits.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

#include "base/large_pages.hpp"

namespace keyblock::formats {
namespace {

using Sixteen = unsigned char __attribute__((vector_size(16)));  // vector type of GCC and Clang, for any processor
using Lanes = std::uint64_t __attribute__((vector_size(16)));

/// Returns one bit per character, of sixteen that are all ones or all zeros.
std::uint64_t bits_of(Sixteen characters) {
  const auto bits = [](std::uint64_t lane) { return (lane & 0x0101010101010101) * 0x0102040810204080 >> 56; };
  const auto lanes = reinterpret_cast<Lanes>(characters);
  return bits(lanes[0]) | bits(lanes[1]) << 8;
}

/// Finds the bits of a block of numbers without exponents, white space and commas; returns false for any other.
bool find_usual(const char* block, std::uint64_t& words) {
  if constexpr (std::endian::native != std::endian::little) return false;
  Sixteen usual = ~Sixteen{};
  words = 0;
  for (std::size_t i = 0; i < kBlock; i += sizeof(Sixteen)) {
    Sixteen c;
    std::memcpy(&c, block + i, sizeof c);
    const auto white = (c == ' ') | (c - '\t' <= '\r' - '\t') | (c == ',');
    const auto word = (c - '0' <= 9) | (c == '-') | (c == '.') | (c == '+');
    usual &= reinterpret_cast<Sixteen>(white | word);
    words |= bits_of(reinterpret_cast<Sixteen>(word)) << i;
  }
  const auto lanes = reinterpret_cast<Lanes>(usual);
  return (lanes[0] & lanes[1]) == ~std::uint64_t{0};
}

/// Finds the bits of any characters; `in_comment` continues from block to block.
std::uint64_t find_by_role(std::string_view text, std::size_t first, const Splitter& splitter, bool& in_comment) {
  std::uint64_t words = 0;
  for (std::size_t at = first; at < std::min(first + kBlock, text.size()); ++at) {
    const Role role = splitter.role_at(at);
    in_comment = (in_comment || role == Role::comment) && !is_line_end(text[at]);
    if (!in_comment && role == Role::ordinary) words |= std::uint64_t{1} << (at - first);
  }
  return words;
}

}  // namespace

std::vector<std::uint64_t> word_bits(std::string_view text, Syntax syntax) {
  const Splitter splitter(text, syntax);
  std::vector<std::uint64_t> bits;
  reserve_large(bits, text.size() / kBlock + 1);
  bool in_comment = false;
  for (std::size_t at = 0; at < text.size(); at += kBlock) {
    std::uint64_t words = 0;
    const bool is_usual = !in_comment && text.size() - at >= kBlock && find_usual(text.data() + at, words);
    bits.push_back(is_usual ? words : find_by_role(text, at, splitter, in_comment));
  }
  return bits;
}

std::size_t count_words(const std::vector<std::uint64_t>& bits) {
  std::uint64_t before = 0;
  std::size_t count = 0;
  for (const std::uint64_t block : bits) {
    count += static_cast<std::size_t>(std::popcount(block & edge_bits(block, before)));
    before = block;
  }
  return count;
}

}  // namespace keyblock::formats
