// Draws random geometries: drawings, blocks and covers.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/format.hpp"
#include "tests/validate/dice.hpp"

namespace keyblock::support::drawn {

/// Lines anywhere; now and then some of them close an outline.
Drawing drawing(Dice& dice);

/// The same with bolts.
formats::Content native_drawing(Dice& dice);
formats::Content blocks(Dice& dice);
formats::Content cover(Dice& dice);

}  // namespace keyblock::support::drawn
