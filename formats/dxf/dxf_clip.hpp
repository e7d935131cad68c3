// Joints that run beyond the boundary of a drawing, cut off at it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "problem/drawing.hpp"

namespace keyblock::formats {

/// Keeps of every joint what lies inside a closed chain of boundary lines, and outside every chain within one that has
/// a hole point in it; joints along the boundary go, for it is there already. What is changed is told in one warning.
/// Boundary lines drawn twice count once. Where an end of a boundary line is loose, or three meet, nothing is cut off,
/// and a warning says where, and how wide the gap is.
Warnings clip_joints(Drawing& drawing);

}  // namespace keyblock::formats
