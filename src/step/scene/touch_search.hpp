// Which touches a step reckons with, and which it finds it should have.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "step/scene/standard_scene.hpp"

namespace keyblock {

/// The vertex at which the edge, or the part of it, ends that lies under the point of the touch: its joint is the one
/// that the touch is on.
VertexIndex edge_under(const Touch& touch, const Model& model, const Table<VertexIndex, Point>& vertices);

/// Pairs within reach of a step of `dt`, as touches.
Touches touches_of(const StandardScene& scene, const Motion& motion, const Scales& scales, double dt);

/// Touches that overlap at the end of a motion to `vertices` by more than a named share of block size and are not in
/// `known`: corners that came round.
Touches newly_overlapping(const StandardScene& scene, const Motion& start, const Table<VertexIndex, Point>& vertices,
                          const Touches& known, const Scales& scales);

/// Names as the rest gap of each touch the overlap at the start of a step that no force answers for: corners that a
/// jump or their neighbours pushed past each other. To push it out within a step would make velocity of it, the more
/// the shorter the step. Round-off and what is left of a solution is pushed out; and all of it where springs stop
/// impacts, whose forces follow the gap.
void leave_overlaps(const StandardScene& scene, const Motion& start, const Scales& scales, Touches& touches);

/// Touches that are closed at the start, within a share of block size, and do not approach as an impact would.
Touches resting_touches(const StandardScene& scene, const Motion& motion, const Scales& scales);

}  // namespace keyblock
