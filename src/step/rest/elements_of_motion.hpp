// Combines two motions of a scene: some elements of one, the others of the other.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "step/scene/standard_scene.hpp"

namespace keyblock {

/// Returns `motion` with the chosen elements, and all that belongs to them, as in `from`. A contact, bond or bolt
/// belongs to them if one of its two elements is chosen.
Motion with_elements_of(const StandardScene& scene, const ChosenElements& chosen, const Motion& from, Motion motion);

}  // namespace keyblock
