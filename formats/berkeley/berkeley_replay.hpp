// The replay file of Berkeley's program: the blocks as they stood, frame after frame (`*.replay`).
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers in this order, line breaks without meaning; all of public source [S].
//   nSaved nBlocks nBolts oo     frames behind the first; oo: vertex slots
//   nF nL nMe                    fixed, loading, measured points
//   (nBlocks + 1) × material start end         slots as in the block file
//   (nSaved + 1) frames, the state before the first step among them, each of
//     (oo + 1) × j x y
//     nBolts × x1 y1 x2 y2 n1 n2 e t f
//     (nF + nL + nMe + 1) × type x y block
// Of every list but that of the bolts the first row is without meaning. There are no times: frames are numbered as
// steps. An aborted run leaves its last frame cut off: the whole ones are read, with a warning.
#pragma once

#include "formats/format.hpp"

namespace keyblock::formats {

extern const Format kBerkeleyReplay;

}  // namespace keyblock::formats
