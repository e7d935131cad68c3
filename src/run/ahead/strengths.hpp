// Checks which materials of a problem are elastoplastic, and whether a run supports them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/scene/scene.hpp"
#include "problem/problem.hpp"
#include "settings/settings.hpp"

namespace keyblock {

/// Throws InputError if a run would ignore the strength of a material: nothing yields under Shi's rules.
void require_readable_strengths(const Problem& problem, const Settings& settings);

/// Returns warnings about the elastoplastic materials and points of a scene; `place`: of its NMM bodies. Throws
/// InputError if softening by fracture energy would snap back within a point, or if an elastoplastic block is rigid.
Warnings look_at_strengths(const Scene& scene, const Place& place);

}  // namespace keyblock
