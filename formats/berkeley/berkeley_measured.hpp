// Reads the measured points of Berkeley's program over time (`*_meas.m`).
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One block per point, k from 1 [S]:
//   measpointk=[
//   step time dt x y dcum vx vy v      dcum: displacement since the start
//   ...
//   ];
// Berkeley's program writes at places computed beforehand: bytes that it left out are zero and read as white space.
#pragma once

#include "formats/format.hpp"

namespace keyblock::formats {

extern const Format kBerkeleyMeasured;

}  // namespace keyblock::formats
