// Contacts of dynamics `standard` as frames report them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "result/contact_frame.hpp"
#include "step/scene/standard_scene.hpp"

namespace keyblock {

/// Closed contacts with their forces, and open ones that a step from here would look at. `before`: vertices at the
/// start of the last step, whose forces act along the normals of its middle; empty where nothing moved since, or where
/// the forces are those of a state at rest.
ContactFrames contact_frames(const StandardScene& scene, const Motion& motion, const State& state,
                             const StartPlaces& unloaded, const Table<VertexIndex, Point>& before);

}  // namespace keyblock
