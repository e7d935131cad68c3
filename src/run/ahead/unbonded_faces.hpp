// Finds faces whose cohesion or tensile strength would act on nothing, before the run.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/error.hpp"
#include "model/scene/scene.hpp"

namespace keyblock {

/// Returns the warning `strength_without_bond` at `place` if faces whose joint material has strength lie side by side
/// at the start but too far apart to be bonded, or if the scene has such faces and none is bonded. Empty unless the
/// steps are those of Dynamics::standard.
Warnings unbonded_faces(const Scene& scene, const Place& place);

}  // namespace keyblock
