// What steps hand on to each other, as members to save and restore.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/archive.hpp"
#include "step/scene/standard_scene.hpp"

namespace keyblock {

/// What a point of rock that may yield remembers.
void describe(Archive& archive, YieldState& point);

/// Of a motion of the same scene, as `start_motion` makes it; contacts and bonds lie between `vertices`.
void describe(Archive& archive, Motion& motion, VertexIndex vertices);

}  // namespace keyblock
