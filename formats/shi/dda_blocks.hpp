// Reads and writes the block file, which Shi's cutting program passes to his analysis program (`blck`, `block.in`,
// `*.blk`).
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers in this order, line breaks without meaning. [S] public source, [C] its comments.
//   nBlocks nBolts oo                 oo: vertex slots                                                     [S]
//   nF nL nMe                         fixed (after cutting), loading, measured points                      [S]
//   nBlocks × material start end      first and last vertex slot, from 1                                   [S]
//   oo × j x y                        j: joint material                                                    [S]
//   nBolts × x1 y1 x2 y2 n1 n2 e t f  ends, carrying blocks, stiffness, strength, pre-tension              [S]
//   (nF + nL + nMe) × type x y block  type: 0 fixed, 1 measured, 2 loading                                 [S]
//                     or x y block                                                                         [C]
// Total: 6 + 3 nBlocks + 3 oo + 9 nBolts + (4 or 3) points. Slots of a block are its vertices counter-clockwise, the
// first again, then three of scratch: (0, greatest radius, area), (0, Sx, Sy), (0, x, y of the centroid). Slot p has
// the material of the edge that arrives there from p − 1 (Berkeley). Another program may mean the edge that leaves. The
// edges that two blocks share decide: both must give them one material. The file cannot hold holes of blocks; only
// outer loops are written, and the caller warns.
#pragma once

#include "formats/format.hpp"

namespace keyblock::formats {

extern const Format kDdaBlocks;         ///< reads both kinds of points, writes those of 4 numbers
extern const Format kDdaBlocksOfThree;  ///< for writing points of 3 numbers; never chosen for reading

}  // namespace keyblock::formats
