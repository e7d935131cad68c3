// Codes numbers of a page: rounds them, compares them with the frame before, sorts their bytes and packs them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace keyblock::report {

/// Returns the bits of the nearest float with `bits` of its 23 bits of fraction. Numbers below 1e-30 become 0, those
/// beyond a float the largest one.
std::uint32_t rounded_bits(double value, int bits);

/// Replaces each group of `row` words by its difference (exclusive or) from the group before. Precondition: `words`
/// holds whole groups.
void subtract_rows(std::span<std::uint32_t> words, std::size_t row);

/// Returns the lowest bytes of all words, then the second ones, and so on.
std::string byte_planes(std::span<const std::uint32_t> words);

/// Returns the words as bytes, the lowest byte first.
std::string little_endian(std::span<const std::uint32_t> words);

/// Returns the bytes packed by zlib, as base64. Throws std::runtime_error if zlib fails.
std::string packed_text(const std::string& bytes);

}  // namespace keyblock::report
