// Profiles: presets of all choices of a run, taken from a name and the analysis file.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "base/error.hpp"
#include "model/settings.hpp"

namespace keyblock {

/// Names of the profiles there are.
std::vector<std::string> profile_names();

/// The settings of profile `name` for this analysis. Throws std::invalid_argument for a name that is none.
Settings profile_settings(const std::string& name, const Analysis& analysis);

}  // namespace keyblock
