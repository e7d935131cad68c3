// Declares how the data passed from step to step are saved and restored, member by member.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/archive.hpp"
#include "step/scene/standard_scene.hpp"

namespace keyblock {

/// Saves or restores the memory of a point of elastoplastic rock.
void describe(Archive& archive, YieldState& point);

/// Saves or restores a motion of the same scene, shaped as `start_motion` makes it. Contacts and bonds lie between
/// `vertices`.
void describe(Archive& archive, Motion& motion, VertexIndex vertices);

}  // namespace keyblock
