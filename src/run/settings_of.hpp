// Every choice of a run: the profile, what the case file sets on it, and what the command line sets on these.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "problem/problem.hpp"
#include "settings/settings_table.hpp"

namespace keyblock {

/// A profile, and why it is the one.
struct ChosenProfile {
  std::string name;
  std::string why;  ///< "the files are of an old program"
};

/// The profile of a run that names none: that of the case file; where that names none, `legacy` for the files of old
/// programs, unless a setting is asked for that `standard` alone reads, and else `standard`. Throws InputError where
/// the case file names one that is none.
ChosenProfile profile_unasked(const Problem& problem, const std::vector<Override>& overrides);

/// The profile asked for; where none is, as above.
ChosenProfile chosen_profile(const Problem& problem, const std::string& asked, const std::vector<Override>& overrides);
std::string profile_of(const Problem& problem, const std::string& asked, const std::vector<Override>& overrides = {});

/// Every choice of a run: the profile, the settings of the case file on it, and the overrides on these. Where the file
/// takes no velocity into a step, and settings ask for motion = dynamic, all of it is taken; `velocity_carry_over`
/// among the settings overrules that. Values of overrides may have a unit ("2 ms"), which is converted to those of the
/// case. Throws InputError for a setting of the case file that is unknown or does not fit, std::invalid_argument for a
/// profile or an override.
Settings settings_of(const Problem& problem, const std::string& profile, const std::vector<Override>& overrides);

}  // namespace keyblock
