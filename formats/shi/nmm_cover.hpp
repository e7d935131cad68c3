// Reads and writes the cover file of Shi's manifold program: the cut mesh that `mc` passes to `mf` (`cvNN`).
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers in this order, line breaks without meaning; all shown by data [D].
//   nE nF nL nM               elements, fixed, loading, measured points
//   nV nC nLoop nLV           vertex slots, physical covers, contact loops, slots of loop vertices
//   (nF + nL + nM) × x y e    e: element, printed as a real
//   nE × start end material   first and last vertex slot; material 0: not assigned
//   nV × x y                  slot end + 1 of an element repeats its first vertex
//   nC × x y                  the mathematical node of each physical cover
//   nE × c1 c2 c3             physical covers of each element
//   nLoop × start end         first and last slot among the loop vertices; end + 1 repeats the first
//   nLV × v j                 vertex slot, and joint material of the edge from here to the next
// Total: 8 + 3 (nF + nL + nM) + 6 nE + 2 (nV + nC + nLoop + nLV). Elements are in any order of their slots.
#pragma once

#include "formats/format.hpp"

namespace keyblock::formats {

extern const Format kNmmCover;

}  // namespace keyblock::formats
