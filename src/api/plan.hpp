// The one way from a case that was read to a scene: profile, settings, files and mesh that settings name, scene, a look
// ahead. Whoever runs a case, or many changes of one, comes this way.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "api/asked_case.hpp"
#include "problem/problem.hpp"
#include "run/prepare.hpp"

namespace keyblock {

/// Profile for old files if neither a person nor a file names one.
enum class OldFiles { legacy, standard };

/// The profile of a run of the case: that asked for, else that of the case file, else by the kind of the files; but
/// `standard` if `case.json` says that `legacy` is not run. Throws UsageError if `case.json` says that it is not run.
ChosenProfile profile_for(const AskedCase& asked, const Problem& problem, OldFiles old_files = OldFiles::legacy);

/// Why `case.json` says that the profile is not run; empty: it does not.
std::string why_not_run(const AskedCase& asked, const std::string& profile);

/// A problem with the files and the mesh that settings name, its profile, and the settings that are left for the scene.
/// A study changes it, and prepares what it has changed.
struct ConfiguredCase {
  ChosenProfile profile;
  std::vector<Override> asked = {};  ///< all settings that were asked for
  Problem problem;
  std::vector<Override> overrides = {};
  std::string file = {};               ///< `case.json`, for messages
  std::vector<Override> of_file = {};  ///< what it sets, for messages
};

/// Under the profile of the case (`profile_for`): reads the files that settings name and puts settings of the mesh into
/// the plan of covers, first those of the case file. Throws as `profile_for`; InputError for a file that cannot be read
/// and for a setting of the case file; std::invalid_argument for another setting.
ConfiguredCase configured(const AskedCase& asked, const Problem& problem, OldFiles old_files = OldFiles::legacy);

/// Configures the case under `profile`, whatever it asks for; `more` overrides its settings.
ConfiguredCase configured_under(const std::string& profile, const AskedCase& asked, const Problem& problem,
                                const std::vector<Override>& more = {});

/// The scene of it. Throws as `keyblock::prepare`, but InputError for a setting of `case.json`.
Prepared prepared_case(const ConfiguredCase& made);

/// A case made ready for its first step.
struct PlannedCase : ConfiguredCase {
  Prepared prepared;
  Warnings warnings = {};  ///< of preparing, then of looking ahead
};

/// The way of a run, of `check` and of the library: with the points of histories, and a look ahead. Throws as
/// `configured`, `with_followed_points` and `prepared_case`.
PlannedCase planned(const AskedCase& asked, const Problem& problem);

}  // namespace keyblock
