// Profiles: presets of all choices of a run, taken from a name and the analysis file.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "settings/settings.hpp"

namespace keyblock {

/// Names of the profiles there are.
std::vector<std::string> profile_names();

/// The profiles that others are variations of, and that cases speak of: legacy and standard.
std::vector<std::string> rule_names();

/// One of those: whose settings a case gives to profile `name` too, and as which it is judged. Throws as below.
std::string rules_of(const std::string& name);

/// How many times as long as the step that is set a profile makes its step of a run in time, with as many fewer of
/// them: 1 but for `draft` and `reference`. Throws as above.
double step_factor(const std::string& name);

/// The settings of profile `name` for this analysis, with `changes` to them. `draft` and `reference` take their share
/// of the step that comes out of these, over the same time. Throws std::invalid_argument for a name that is none.
Settings profile_settings(const std::string& name, const Analysis& analysis,
                          const std::function<void(Settings&)>& changes = {});

}  // namespace keyblock
