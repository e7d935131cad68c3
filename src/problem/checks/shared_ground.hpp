// Finds blocks of a file that overlap, outlines that cross themselves, and holes outside their blocks.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/error.hpp"
#include "problem/blocks.hpp"
#include "problem/cover.hpp"
#include "problem/cover_plan.hpp"
#include "problem/stage.hpp"

namespace keyblock {

/// Warns of blocks that share more than a hundredth of the smaller one: one warning, with the first pair and the count.
/// Files of Shi's cutter overlap by its tolerance, and results of old runs by their penetration; both are far less.
Warnings shared_ground(const Blocks& blocks);

/// Returns one error per outline that crosses itself or a hole, naming the two edges: areas and centroids would be
/// wrong. Outlines are those of blocks, elements, loops and excavations. Crossings narrower than 1e-4 of the size are
/// rounding. Outlines of blocks that come back along an edge are errors too, because contacts of such a spike are not
/// found.
std::vector<InputError> crossed_outlines(const Blocks& blocks);
std::vector<InputError> crossed_outlines(const Cover& cover);
std::vector<InputError> crossed_outlines(const std::vector<Stage>& stages);
std::vector<InputError> crossed_outlines(const CoverPlan& plan);

/// Returns errors for misplaced holes, with which areas and centroids would be wrong. A hole must lie within its outer
/// loop, in no other hole, and run against the direction of the outer loop.
std::vector<InputError> misplaced_holes(const Blocks& blocks);

/// Returns the place of the item if the file gives it, or else the file.
const Place& place_of(const BlockPolygon& block, const Blocks& blocks);
const Place& place_of(const BlockBolt& bolt, const Blocks& blocks);

}  // namespace keyblock
