// Computes the tolerances of cutting from the drawing's ratio e0 and its scale w0. With e0 = 0 the arrangement is exact
// and no point is moved.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "problem/drawing.hpp"

namespace keyblock {

struct CutTolerances {
  double scale = 0;         ///< w0 = 1.02 max(H/2, (W/2)/1.3) over all line end points (Shi's block cutter)
  double merge = 0;         ///< 1.25 e0 w0: nodes nearer than this become one (Shi's block cutter)
  double near_pass = 0;     ///< e0 w0: a segment passing a foreign node nearer than this goes through it
  double reach_ratio = 0;   ///< a line meets another that it misses by 1e-7 of its length (Shi's block cutter)
  double round_off = 0;     ///< moves below this are rounding of the input and of crossings, not reported
  double collinear = 0;     ///< |cross| of neighbouring edges below which their common vertex is straight
  double inset = 0;         ///< 0.005 w0: fixed points of fixed lines stand this far inside the edge (Shi's cutter)
  double vertex_catch = 0;  ///< 1e-5 w0: a point this near to a vertex takes the first such block (Shi's cutter)

  bool is_exact() const { return merge == 0; }
};

CutTolerances cut_tolerances(const Drawing& drawing);

/// Throws InputError, at the line that reaches farthest, if the merging distance is not small compared with the lines.
/// It is too large above nine of ten lengths. It is too large above a twentieth of their median if one point alone
/// makes the scale 20 times as large.
void require_small_merging(const Drawing& drawing, const CutTolerances& tolerances);

}  // namespace keyblock
