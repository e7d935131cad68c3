// Cuts off joints that extend beyond the boundary of a drawing.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "problem/drawing.hpp"

namespace keyblock::formats {

/// Keeps the part of every joint inside a closed chain of boundary lines, and outside every inner chain with a hole
/// point in it. Joints along the boundary are removed, because they repeat it. One warning reports the changes.
/// Boundary lines drawn twice count once. If a boundary line has a loose end, or three meet, nothing is cut off. A
/// warning then names the place, and the width of the gap.
Warnings clip_joints(Drawing& drawing);

}  // namespace keyblock::formats
