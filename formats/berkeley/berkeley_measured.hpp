// The measured points of Berkeley's program in time (`*_meas.m`).
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One block a point, k from 1 [S]:
//   measpointk=[
//   step time dt x y dcum vx vy v      dcum: displacement since the start
//   ...
//   ];
// The old program writes at places computed beforehand: bytes that it left out are zero and read as white space.
#pragma once

#include "formats/format.hpp"

namespace keyblock::formats {

extern const Format kBerkeleyMeasured;

}  // namespace keyblock::formats
