// Every choice of a run: the profile, what the case file sets on it, and what the command line sets on these.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "problem/problem.hpp"
#include "settings/settings_table.hpp"

namespace keyblock {

/// The profile asked for; where none is, that of the case file; where that names none, `standard`. Throws InputError
/// where the case file names one that is none.
std::string profile_of(const Problem& problem, const std::string& asked);

/// Every choice of a run: the profile, the settings of the case file on it, and the overrides on these. Throws
/// InputError for a setting of the case file that is unknown or does not fit, std::invalid_argument for a profile or an
/// override.
Settings settings_of(const Problem& problem, const std::string& profile, const std::vector<Override>& overrides);

}  // namespace keyblock
