// Reports the contacts of dynamics `standard` as contact frames.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "result/contact_frame.hpp"
#include "step/scene/standard_scene.hpp"

namespace keyblock {

/// Returns closed contacts with their forces, and the open ones that the next step would consider. `before`: vertices
/// at the start of the last step, whose forces act along the normals of its middle. It is empty if nothing moved since,
/// and has no effect on a static state.
ContactFrames contact_frames(const StandardScene& scene, const Motion& motion, const State& state,
                             const StartPlaces& unloaded, const Table<VertexIndex, Point>& before);

using LaterContacts = std::function<ContactFrames()>;

/// Returns a function that computes the same after further steps, as long as `scene` and `unloaded` live. In time it
/// copies the motion, which takes less than the search for open contacts.
LaterContacts contact_frames_later(const StandardScene& scene, const Motion& motion, const State& state,
                                   const StartPlaces& unloaded, const Table<VertexIndex, Point>& before);

}  // namespace keyblock
