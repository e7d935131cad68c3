// Bodies without the regions that are dug out of them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cut/bodies/body_graph.hpp"
#include "cut/bodies/change_blocks.hpp"
#include "problem/drawing.hpp"

namespace keyblock {

/// The edges of blocks as lines, which are cut without any merging of crossings. Blocks get no materials so.
Drawing lines_of(const Blocks& blocks);

/// The bodies of the drawing less all that lies within the `regions`, and of each its material (from `blocks` where
/// they are given, whose lines the drawing is). A joint that an outline cuts ends there. Throws InputError where
/// nothing is left.
BodyGraph excavated(const Drawing& drawing, const std::vector<Region>& regions, NodeMerging merging,
                    const Blocks* blocks = nullptr);

}  // namespace keyblock
