// The growth that a case file asks for, as its scene knows it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "model/scene/scene.hpp"
#include "problem/problem.hpp"
#include "settings/settings.hpp"

namespace keyblock {

/// Throws InputError where cracks cannot grow: beside stages or excavations, without a toughness, or where rock may
/// yield; under scaled loads also in time, beside blocks, and under an initial stress, which no factor scales. None
/// where the file asks for none. Its plan says whether loads are scaled.
/// `remade`: the scene of the same case with other cracks.
std::shared_ptr<const CrackGrowth> growth_of(const Problem& problem, const Scene& scene,
                                             std::function<Scene(const Problem&)> remade);

}  // namespace keyblock
