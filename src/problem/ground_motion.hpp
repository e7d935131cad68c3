// A recorded ground motion made an acceleration of all blocks.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "problem/analysis.hpp"

namespace keyblock {

/// The analysis with the motion, in multiples of gravity, as its body acceleration (legacy-formats 2.8: the force on a
/// block is the motion times its weight). Gravity is that of the analysis (DDAML), else unit weight over density of the
/// first block material, as weights are taken too (legacy-formats 3.2). Says so in a warning: the old program read
/// motions and never applied them. Throws InputError where there is no gravity, or where the analysis has a body
/// acceleration already.
Warnings apply_motion(Analysis& analysis, const TimeCurve& motion);

}  // namespace keyblock
