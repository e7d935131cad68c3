// Pairs of boxes of very different sizes: no cell of a grid fits them all.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "geometry/box.hpp"

namespace keyblock {

/// Pairs i < j of boxes that touch when i is grown by `distance`, in no particular order, by an R*-tree filled at once
/// (Beckmann et al. 1990; Leutenegger, Lopez & Edgington 1997): some ten times a fitting grid, whatever the sizes.
std::vector<std::pair<int, int>> touching_by_tree(const std::vector<Box>& boxes, double distance);

/// The same one by one, i ascending, as long as `visit` returns true: there may be n² of them.
void visit_touching(const std::vector<Box>& boxes, double distance, const std::function<bool(int, int)>& visit);

}  // namespace keyblock
