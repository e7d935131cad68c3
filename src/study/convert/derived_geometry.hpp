// Derives one kind of geometry from another, for formats that hold only one of them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "formats/format.hpp"

namespace keyblock::study {

struct Derivation {
  formats::Content content;  ///< drawing or blocks alone
  std::string from;          ///< source part: "drawing"
  std::string sentence;      ///< "cut into 12 blocks"
  Warnings warnings;         ///< about items that could not be included
};

/// Returns the blocks of a drawing, by cutting, or of a cover: its outer loops, with the loops within them as holes.
/// Empty if the content has neither. Throws InputError if the lines close no block. Throws also for a loading point
/// outside all blocks, because later points would get its loads.
std::optional<Derivation> as_blocks(const formats::Content& geometry);

/// Returns lines of blocks, or of the blocks of a cover: every edge once, and a material line across each block. A hole
/// point marks each enclosed gap. Throws InputError if the edges close no block.
std::optional<Derivation> as_lines(const formats::Content& geometry);

}  // namespace keyblock::study
