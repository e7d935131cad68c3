// Computes the settings of profiles: presets of all choices of a run, from a name and the analysis file.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "settings/settings.hpp"

namespace keyblock {

/// Returns the names of all profiles.
std::vector<std::string> profile_names();

/// Returns the two profiles of which the others are variations, and which cases name: legacy and standard.
std::vector<std::string> rule_names();

/// Returns the one of these two that profile `name` varies. A case gives its settings for that one to `name` too, and
/// results of `name` are compared as its results. Throws like `profile_settings`.
std::string rules_of(const std::string& name);

/// Returns the factor on the time step of a dynamic run, with as many fewer steps: 1 except for `draft` and
/// `reference`. Throws like `profile_settings`.
double step_factor(const std::string& name);

/// Returns the settings of profile `name` for this analysis, with `changes` applied. `draft` and `reference` then scale
/// the resulting step, over the same time. Throws std::invalid_argument for an unknown name.
Settings profile_settings(const std::string& name, const Analysis& analysis,
                          const std::function<void(Settings&)>& changes = {});

}  // namespace keyblock
