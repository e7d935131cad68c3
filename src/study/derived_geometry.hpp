// One kind of geometry from another, for formats that hold only one of them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "formats/format.hpp"

namespace keyblock::study {

struct Derivation {
  formats::Content content;  ///< drawing or blocks alone
  std::string from;          ///< the part that it was made of: "drawing"
  std::string sentence;      ///< "cut into 12 blocks"
};

/// What the drawing, blocks or cover of the content can become: a drawing becomes blocks by cutting; blocks become the lines of
/// their edges, each once, with a material line across each block; a cover becomes the blocks of its outer loops, with those within
/// them as holes, and the lines of these.
std::vector<Derivation> derivations(const formats::Content& geometry);

}  // namespace keyblock::study
