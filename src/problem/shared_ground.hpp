// Blocks that a file puts where others are, outlines that cross themselves, and holes outside their blocks.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/error.hpp"
#include "problem/blocks.hpp"
#include "problem/cover.hpp"
#include "problem/cover_plan.hpp"
#include "problem/stage.hpp"

namespace keyblock {

/// Blocks that have more than a hundredth of the smaller one in common: one warning, with the first pair and how many
/// there are. Files of the old cutter overlap by its tolerance, and results of old runs by what they pressed, both far
/// less.
Warnings shared_ground(const Blocks& blocks);

/// Outlines that cross themselves or a hole, one error a block (an element, a loop, an excavation) that names the two
/// edges: areas and centroids would be wrong. Crossings narrower than 1e-4 of the size are rounding. Of blocks also
/// outlines that come back along an edge: contacts of such a spike without width are not found.
std::vector<InputError> crossed_outlines(const Blocks& blocks);
std::vector<InputError> crossed_outlines(const Cover& cover);
std::vector<InputError> crossed_outlines(const std::vector<Stage>& stages);
std::vector<InputError> crossed_outlines(const CoverPlan& plan);

/// Holes that do not lie within their outer loop, or lie in another hole, or turn as the outer loop does: areas and
/// centroids would be wrong.
std::vector<InputError> misplaced_holes(const Blocks& blocks);

/// Where the file speaks of it, else the file.
const Place& place_of(const BlockPolygon& block, const Blocks& blocks);
const Place& place_of(const BlockBolt& bolt, const Blocks& blocks);

}  // namespace keyblock
