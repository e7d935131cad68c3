// Finds pairs of touching boxes of very different sizes, for which no cell of a grid fits.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "geometry/box.hpp"

namespace keyblock {

/// Returns pairs i < j of boxes that touch when i is grown by `distance`, in no particular order. It uses an R*-tree
/// filled at once (Beckmann et al. 1990; Leutenegger, Lopez & Edgington 1997): some ten times the time of a fitting
/// grid, for all sizes.
std::vector<std::pair<int, int>> touching_by_tree(const std::vector<Box>& boxes, double distance);

/// Visits the same pairs one by one, i ascending, as long as `visit` returns true; there may be n² of them.
void visit_touching(const std::vector<Box>& boxes, double distance, const std::function<bool(int, int)>& visit);

}  // namespace keyblock
