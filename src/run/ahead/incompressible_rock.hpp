// Finds nearly incompressible rock on covers whose functions lock, before the run.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/error.hpp"
#include "model/scene/scene.hpp"

namespace keyblock {

/// Returns the warning `rock_may_lock` at `place` if NMM bodies in plane strain have constant or derived functions and
/// a Poisson's ratio from 0.49 on.
Warnings incompressible_rock(const Scene& scene, const Place& place);

}  // namespace keyblock
