// Which materials of a problem may yield, and whether a run lets them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/scene/scene.hpp"
#include "problem/problem.hpp"
#include "settings/settings.hpp"

namespace keyblock {

/// Throws InputError where a material has a strength that a run would take no notice of: nothing yields under the rules
/// of the old programs.
void require_readable_strengths(const Problem& problem, const Settings& settings);

/// What is to be said of the materials and the points of a scene that may yield; `place` of its bodies on covers.
/// Throws InputError where softening by fracture energy would snap back within a point, and where a block that may
/// yield is rigid.
Warnings look_at_strengths(const Scene& scene, const Place& place);

}  // namespace keyblock
