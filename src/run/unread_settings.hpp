// Settings that nothing reads in the scenes of a problem, although their names and values are sound.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "model/scene/scene.hpp"
#include "problem/problem.hpp"

namespace keyblock {

/// Why a setting has no effect on a run of these scenes: "is read where a drawing is cut"; empty where it has one, or
/// where it is unknown. `name` may end in the number of a material.
std::string why_unread(const Problem& problem, const Scene& first, const std::string& name);

}  // namespace keyblock
