// Computes one bit per character, set if it belongs to a word: 64 characters at once, no branch per word.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "formats/text/splitter.hpp"

namespace keyblock::formats {

inline constexpr std::size_t kBlock = 64;  // characters per number of bits, the first of them lowest

/// Returns the bits of a text that begins outside words and comments; zero after its end.
std::vector<std::uint64_t> word_bits(std::string_view text, Syntax syntax);

/// Returns the bits of the characters at which a word begins, or after which one ends; `before`: those of the block
/// before.
constexpr std::uint64_t edge_bits(std::uint64_t bits, std::uint64_t before) {
  return bits ^ (bits << 1 | before >> (kBlock - 1));
}

std::size_t count_words(const std::vector<std::uint64_t>& bits);

}  // namespace keyblock::formats
