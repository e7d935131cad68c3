// Reads the crack growth that a case file requests, completed from its scene.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "model/scene/scene.hpp"
#include "problem/problem.hpp"
#include "settings/settings.hpp"

namespace keyblock {

/// Returns the growth; null if the file requests none. Its plan states whether loads are scaled. Throws InputError if
/// cracks cannot grow: with stages or excavations, without a toughness, or in elastoplastic rock. Scaled loads also
/// exclude dynamics, DDA blocks, and an initial stress, which no load factor scales. `remade` makes the scene of the
/// same case with other cracks.
std::shared_ptr<const CrackGrowth> growth_of(const Problem& problem, const Scene& scene,
                                             std::function<Scene(const Problem&)> remade);

}  // namespace keyblock
