// Finds toes of slopes that a rigid floor in front of them holds.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/error.hpp"
#include "model/scene/scene.hpp"

namespace keyblock {

/// Returns the warning `toe_wedged` at `place` for blocks with a toe: a sharp corner between a free face and a face on
/// which they could slide. The toe lies on a free edge of another block, into which it would slide. Limit equilibrium
/// of a plane failure (Hoek and Bray 1981, ch. 7) lets it pass; rigid corners do not. Empty for NMM bodies, and for
/// faces whose friction alone gives a factor of 2 or more.
Warnings wedged_toes(const Scene& scene, const Place& place);

}  // namespace keyblock
