// Reads ground motions that accompany an analysis of Berkeley's program: horizontal accelerations, as multiples of
// gravity.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Format "shake" [S]:   two header lines, the second begins with the number of values; then the values, 8 per line,
//                       0.02 of time apart. Recognised only if the first line begins with a word that is not a number.
// Format "matlab" [S]:  time step and number of values on the first line, then one value per line.
// The first value belongs to time 0. Berkeley's program never applied these values; here they accelerate the blocks of
// a case (problem/ground_motion.hpp).
#pragma once

#include "formats/format.hpp"

namespace keyblock::formats {

extern const Format kMotionShake;
extern const Format kMotionMatlab;

}  // namespace keyblock::formats
