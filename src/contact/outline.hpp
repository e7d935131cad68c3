// The corners of a convex element: its boundary without the vertices that lie on a straight edge.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "model/model.hpp"

namespace keyblock {

/// Corners counter-clockwise; edge i runs from corner i to corner i+1. An affine map keeps straight edges straight, so
/// an outline holds for the whole run.
using Outline = std::vector<VertexIndex>;

/// The outline, empty where the element is not convex or has a hole.
Outline convex_outline(const Model& model, ElementIndex element);

}  // namespace keyblock
