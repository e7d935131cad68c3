// Finds the contact candidates of a step, and contacts that it missed. Theory: docs/theory/04-contact-geometry.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "step/scene/standard_scene.hpp"

namespace keyblock {

/// Returns the end vertex of the edge, or part of an edge, under the point of the contact; its joint is that of the
/// contact.
VertexIndex edge_under(const Touch& touch, const Model& model, const Table<VertexIndex, Point>& vertices);

/// Returns the contact candidates within reach of a step of `dt`.
Touches touches_of(const StandardScene& scene, const Motion& motion, const Scales& scales, double dt);

/// Gives contacts the joint materials of the edges under their points.
void name_joints(Touches& touches, const Model& model, const Table<VertexIndex, Point>& vertices);

/// Returns contacts that overlap by more than kNewOverlap of block size after a motion to `vertices`. Those in `known`
/// are left out: the rest are corners that came round an edge.
Touches newly_overlapping(const StandardScene& scene, const Motion& start, const Table<VertexIndex, Point>& vertices,
                          const Touches& known, const Scales& scales);

/// Sets the rest gap of each contact to the initial overlap of the step that no force balances. Such overlaps come from
/// jumps or neighbours that pushed corners past each other. Pushing them out within a step would create velocity, more
/// in shorter steps. Round-off and errors of earlier solutions are pushed out. If springs stop impacts, all overlap is
/// pushed out, because their forces follow the gap.
void leave_overlaps(const StandardScene& scene, const Motion& start, const Scales& scales, Touches& touches);

/// Returns contacts with a gap or overlap below `distance`, and bonded ones, that approach too slowly for an impact.
Touches meeting_touches(const StandardScene& scene, const Motion& motion, const Scales& scales, double distance);

/// Returns those that are closed: within kTouching of block size, or bonded.
Touches resting_touches(const StandardScene& scene, const Motion& motion, const Scales& scales);

}  // namespace keyblock
