// Reads and writes the native geometry (line) file, the input of Shi's cutting program.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers in this order, line breaks without meaning. [D] shown by data, [S] by public source, [R] inferred.
//   e0                      minimum edge-node distance over the domain scale                           [S][D]
//   nJ nB nM nBolt nF nL nMe nH   lines in all, boundary lines among them (first), material lines, bolts,
//                           fixed lines, loading, measured, hole points                                [S][D]
//   nJ    × x1 y1 x2 y2 n   n: joint material from 1                                                   [S][D]
//   nM    × x1 y1 x2 y2 n   n: block material from 1                                                   [S]
//   nBolt × x1 y1 x2 y2 e t f   stiffness, strength, pre-tension                                       [R]
//   nF    × x1 y1 x2 y2     a point repeats its coordinates                                            [S][D]
//   nL, nMe, nH × x y                                                                                  [S]
// Total: 9 + 5 (nJ + nM) + 7 nBolt + 4 nF + 2 (nL + nMe + nH).
// Variants are read, with a warning, only if no other layout gives the file's total [R]. They are fixed points of 2
// numbers; bolts of 0, 4 (ends only) or 9 numbers (ends, two block numbers, e t f); no nH; points missing at the end of
// the file.
#pragma once

#include "formats/format.hpp"

namespace keyblock::formats {

extern const Format kDdaGeometry;

}  // namespace keyblock::formats
