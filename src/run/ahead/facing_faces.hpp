// Checks the joint materials of faces that lie side by side, before the run.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/error.hpp"
#include "model/scene/scene.hpp"

namespace keyblock {

/// Returns warnings at `place` about faces that lie side by side at the start. `strength_without_bond`: their joint
/// material has cohesion or tensile strength, but they are too far apart to be bonded; or the scene has faces with
/// strength, and none is bonded. `joint_materials_differ`: two faces of a joint have different joint materials. Empty
/// unless the steps are those of Dynamics::standard.
Warnings facing_faces(const Scene& scene, const Place& place);

}  // namespace keyblock
