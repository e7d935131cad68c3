// Finds settings without effect in the scenes of a problem, although their names and values are valid.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "model/scene/scene.hpp"
#include "problem/problem.hpp"

namespace keyblock {

/// Returns the reason why a setting has no effect on a run of these scenes: "is read where a drawing is cut". Empty if
/// it has one, or if it is unknown. `name` may end in the number of a material.
std::string why_unread(const Problem& problem, const Scene& first, const std::string& name);

}  // namespace keyblock
