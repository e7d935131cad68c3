// Cracks whose faces the joint material holds together.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/error.hpp"
#include "model/scene/scene.hpp"

namespace keyblock {

/// One warning where contact is felt and the faces at a tip, or those of cracks to come, have a joint material with
/// cohesion or tensile strength: they hold each other, and the factors of the tip are those of a bonded crack.
Warnings bonded_crack_faces(const Scene& scene, const Place& place);

}  // namespace keyblock
