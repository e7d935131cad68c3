// Converts a recorded ground motion into an acceleration of all blocks.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "problem/analysis.hpp"

namespace keyblock {

/// Sets the motion, in multiples of gravity, as the body acceleration of the analysis. The force on a block is the
/// motion times its weight (legacy-formats 2.8).
///
/// Gravity is that of the analysis (DDAML), or else unit weight over density of the first block material, as for
/// weights (legacy-formats 3.2). Returns a warning, because the Berkeley program read motions but never applied them.
/// Throws InputError if there is no gravity, or if the analysis has a body acceleration already.
Warnings apply_motion(Analysis& analysis, const TimeCurve& motion);

}  // namespace keyblock
