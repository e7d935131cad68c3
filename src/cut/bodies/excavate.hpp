// Removes excavated regions from bodies.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cut/bodies/body_graph.hpp"
#include "problem/blocks.hpp"
#include "problem/drawing.hpp"

namespace keyblock {

/// Region to excavate, bounded by a closed chain. The faces left by the excavation get the joint material.
struct Region {
  std::vector<Point> outline;
  int joint_material = 0;  ///< index from 0
};

/// Returns the edges of blocks as lines, to be cut without merging of crossings. Block materials are not kept.
Drawing lines_of(const Blocks& blocks);

/// Returns the bodies of the drawing without the `regions`, each with its material. With `blocks`, the drawing must be
/// their lines, and materials are theirs. A joint that an outline cuts ends there. Throws InputError if nothing is
/// left.
BodyGraph excavated(const Drawing& drawing, const std::vector<Region>& regions, NodeMerging merging,
                    const Blocks* blocks = nullptr);

}  // namespace keyblock
