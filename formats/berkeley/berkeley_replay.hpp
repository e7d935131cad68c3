// Reads the replay file of Berkeley's program: the positions of the blocks, frame after frame (`*.replay`).
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers in this order, line breaks without meaning; all from public source [S].
//   nSaved nBlocks nBolts oo     frames after the first; oo: vertex slots
//   nF nL nMe                    fixed, loading, measured points
//   (nBlocks + 1) × material start end         slots as in the block file
//   (nSaved + 1) frames, the state before the first step among them, each of
//     (oo + 1) × j x y
//     nBolts × x1 y1 x2 y2 n1 n2 e t f
//     (nF + nL + nMe + 1) × type x y block
// The first row of every list except that of the bolts has no meaning. There are no times: the steps are the numbers of
// the frames. An aborted run leaves its last frame incomplete: the complete ones are read, with a warning.
#pragma once

#include "formats/format.hpp"

namespace keyblock::formats {

extern const Format kBerkeleyReplay;

}  // namespace keyblock::formats
