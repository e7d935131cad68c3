// Blocks that a file puts where others are, and holes that it puts outside their blocks.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/error.hpp"
#include "problem/blocks.hpp"

namespace keyblock {

/// Blocks that have more than a hundredth of the smaller one in common: one warning, with the first pair and how many
/// there are. Files of the old cutter overlap by its tolerance, and results of old runs by what they pressed, both far
/// less.
Warnings shared_ground(const Blocks& blocks);

/// Holes that do not lie within their outer loop, or turn as it does: areas and centroids would be wrong.
std::vector<InputError> misplaced_holes(const Blocks& blocks);

/// Where the file speaks of it, else the file.
const Place& place_of(const BlockPolygon& block, const Blocks& blocks);
const Place& place_of(const BlockBolt& bolt, const Blocks& blocks);

}  // namespace keyblock
