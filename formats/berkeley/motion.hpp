// Ground motions as Berkeley's program read them beside its analysis: horizontal accelerations, as multiples of
// gravity.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Format "shake" [S]:   two header lines, the second begins with the number of values; then the values, 8 a line,
//                       0.02 of time apart. Recognised only where the first line begins with a word that is no number.
// Format "matlab" [S]:  time step and number of values on the first line, then one value a line.
// The first value stands for time 0. The old program never applied what it read; beside a case it accelerates the
// blocks here (problem/ground_motion.hpp).
#pragma once

#include "formats/format.hpp"

namespace keyblock::formats {

extern const Format kMotionShake;
extern const Format kMotionMatlab;

}  // namespace keyblock::formats
