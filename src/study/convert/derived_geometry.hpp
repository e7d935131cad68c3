// One kind of geometry from another, for formats that hold only one of them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "formats/format.hpp"

namespace keyblock::study {

struct Derivation {
  formats::Content content;  ///< drawing or blocks alone
  std::string from;          ///< the part that it was made of: "drawing"
  std::string sentence;      ///< "cut into 12 blocks"
  Warnings warnings;         ///< of what found no place in it
};

/// Blocks of a drawing, by cutting, or of a cover: its outer loops, with the loops within them as holes. Throws
/// InputError where the lines close no block and at a loading point outside all blocks: the points behind it would get
/// its loads. Nothing where the content has neither drawing nor cover.
std::optional<Derivation> as_blocks(const formats::Content& geometry);

/// Lines of blocks, or of the blocks of a cover: every edge once, a material line across each block, and a hole point
/// in each gap that they enclose. Throws InputError where the edges close no block.
std::optional<Derivation> as_lines(const formats::Content& geometry);

}  // namespace keyblock::study
