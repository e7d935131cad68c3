// Warns of cracks whose faces the joint material holds together.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/error.hpp"
#include "model/scene/scene.hpp"

namespace keyblock {

/// Returns a warning if contact acts and the faces of a crack are bonded. This holds if the joint material at a tip, or
/// of future cracks, has cohesion or tensile strength. The stress intensity factors are then those of a bonded crack.
Warnings bonded_crack_faces(const Scene& scene, const Place& place);

}  // namespace keyblock
