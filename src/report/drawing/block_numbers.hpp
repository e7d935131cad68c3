// Draws numbers of blocks, each as large as fits inside its block.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "report/drawing/svg.hpp"

namespace keyblock::report {

/// Numbers of blocks in pictures: none, or those of all blocks that have room for it.
enum class Numbers { none, all };

/// A block on the page: the outer loop first, then holes.
struct NumberedBlock {
  int number = 0;  ///< from 1
  std::vector<std::vector<Point>> loops;
};

/// Place and size of the text of a number.
struct NumberInside {
  Point middle;
  double size = 0;  ///< of the face; 0: it fits nowhere, or cannot be read
};

/// Returns the largest size, up to the usual one, at which `words` fit inside the loops.
NumberInside largest_inside(const std::vector<std::vector<Point>>& loops, const std::string& words);

/// Writes the numbers of all blocks that are large enough, and returns the number of the others.
std::size_t draw_block_numbers(SvgPage& page, const std::vector<NumberedBlock>& blocks);

/// Returns "; 3 blocks are too small for their number"; empty for 0.
std::string without_number_in_words(std::size_t count);

}  // namespace keyblock::report
