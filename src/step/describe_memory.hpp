// What steps hand on to each other, as members to save and restore.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/archive.hpp"
#include "step/advance.hpp"
#include "step/standard_scene.hpp"

namespace keyblock {

/// Of a stepping of the same scene, as `start` makes it. Of the solver, only whether it gave up iterations: its factor
/// is that of any new solver.
void describe(Archive& archive, Stepping& stepping);

/// Of a motion of the same scene, as `start_motion` makes it; contacts and bonds lie between `vertices`.
void describe(Archive& archive, Motion& motion, VertexIndex vertices);

}  // namespace keyblock
