// Prepares a case that was read: profile, settings, files and mesh that settings name, scene, checks before the run.
// All runs and studies of a case use it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "api/asked_case.hpp"
#include "problem/problem.hpp"
#include "run/prepare.hpp"

namespace keyblock {

/// Profile for files of Shi's formats if neither the user nor a file names one.
enum class OldFiles { legacy, standard };

/// Returns the profile of a run: the requested one, otherwise that of the case file, otherwise the default of the kind
/// of files. Returns `standard` if `case.json` says that `legacy` is not run. Throws UsageError if `case.json` says
/// that the profile is not run.
ChosenProfile profile_for(const AskedCase& asked, const Problem& problem, OldFiles old_files = OldFiles::legacy);

/// Returns the reason in `case.json` for not running the profile; empty if it is run.
std::string why_not_run(const AskedCase& asked, const std::string& profile);

/// Problem with the files and the mesh that settings name, its profile, and the remaining settings for the scene. A
/// study changes it, and prepares the result.
struct ConfiguredCase {
  ChosenProfile profile;
  std::vector<Override> asked = {};  ///< all requested settings
  Problem problem;
  std::vector<Override> overrides = {};
  std::string file = {};               ///< `case.json`, for messages
  std::vector<Override> of_file = {};  ///< its settings, for messages
};

/// Configures the problem under the profile of the case (`profile_for`). Reads the files that settings name, and puts
/// settings of the mesh into the cover plan, first those of the case file. Throws like `profile_for`; InputError for a
/// file that cannot be read and for a setting of the case file; std::invalid_argument for another setting.
ConfiguredCase configured(const AskedCase& asked, const Problem& problem, OldFiles old_files = OldFiles::legacy);

/// Configures the case under `profile`, even if it requests another; `more` overrides its settings.
ConfiguredCase configured_under(const std::string& profile, const AskedCase& asked, const Problem& problem,
                                const std::vector<Override>& more = {});

/// Returns the files that settings name: those of the case file, then requested ones, which overrule them.
std::vector<std::string> named_files(const ConfiguredCase& made);

/// Builds the scene of the case. Throws like `keyblock::prepare`, but InputError for a setting of `case.json`.
Prepared prepared_case(const ConfiguredCase& made);

/// Case that is ready for its first step.
struct PlannedCase : ConfiguredCase {
  Prepared prepared;
  Warnings warnings = {};  ///< of the preparation, then of the checks before the run
};

/// Plans a case for `run`, `check` and the library: with the points of histories, and checks before the run. Throws
/// like `configured`, `with_followed_points` and `prepared_case`.
PlannedCase planned(const AskedCase& asked, const Problem& problem);

}  // namespace keyblock
