// Declares the warnings of a case that is prepared: input without effect, doubtful loads, plans and strengths.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/error.hpp"
#include "model/scene/scene.hpp"
#include "problem/problem.hpp"
#include "settings/settings_table.hpp"

namespace keyblock {

/// Warns of input that the profile ignores.
Warnings not_modelled(const Blocks& blocks, const Analysis& analysis, const Settings& settings);

/// Warns of settings without effect: those of the case file, of its stages and of the command.
Warnings without_effect(const Problem& problem, const std::vector<Override>& overrides, const Scene& first);

Warnings warnings_of_loads(const Problem& problem, const Scene& first);

/// Throws InputError if the plan does not fit the bodies.
Warnings warnings_of_plan(const Problem& problem, const Scene& first);

/// Returns a warning repeated by several stages for the first of them.
Warnings warnings_of_strengths(const Scene& first, const Place& place);

}  // namespace keyblock
