// Files of the family that are recognised but not read yet, so that the refusal can name them.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// NMM cover (`cvNN`) [D]: nE nF nL nM nV nC nLoop nLV, total 8 + 3 (nF+nL+nM) + 6 nE + 2 (nV+nC+nLoop+nLV).
// NMM analysis (`mfNN`) [D]: k01 n5 nb nj g2 g1 g0, total 11 + 2 nL + 14 nb + 3 nj; nL stands in the cover file.
// Extended 1.5: first word begins `#!0xDDA`.
// Disk DDA (`.par`) [inferred]: 0, 1 or 2, then two reals between 0 and 1.
#pragma once

#include "formats/format.hpp"

namespace keyblock::formats {

extern const Format kNmmCover;
extern const Format kNmmAnalysis;
extern const Format kDdaExtended;
extern const Format kDiskDda;

}  // namespace keyblock::formats
