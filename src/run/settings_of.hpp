// Collects all choices of a run: the profile, the settings of the case file, and those of the command line.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "problem/problem.hpp"
#include "settings/settings_table.hpp"

namespace keyblock {

/// Profile, and the reason for it.
struct ChosenProfile {
  std::string name;
  std::string why;  ///< "the files are of an old program"
};

/// Returns the profile of a run that names none: that of the case file, if it names one. Otherwise it is `legacy` for
/// files of Shi's programs, unless a setting is requested that only `standard` reads, and `standard` for all others.
/// Throws InputError if the case file names an unknown profile.
ChosenProfile profile_unasked(const Problem& problem, const std::vector<Override>& overrides);

/// Returns the requested profile, or that of `profile_unasked` if none is requested.
ChosenProfile chosen_profile(const Problem& problem, const std::string& asked, const std::vector<Override>& overrides);
std::string profile_of(const Problem& problem, const std::string& asked, const std::vector<Override>& overrides = {});

/// Returns all choices of a run: the profile, then the settings of the case file, then the overrides. If the file
/// carries no velocity into a step and settings request motion = dynamic, all velocity is carried, unless a setting
/// `velocity_carry_over` says otherwise. A unit in an override ("2 ms") is converted to those of the case. Throws
/// InputError for an unknown or invalid setting of the case file, std::invalid_argument for a profile or an override.
Settings settings_of(const Problem& problem, const std::string& profile, const std::vector<Override>& overrides);

}  // namespace keyblock
