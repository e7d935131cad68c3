// A case as a command line asks for it, and the one way from there to a plan: every command that prepares a case takes
// its files, profile, settings and mesh from here.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "formats/format.hpp"
#include "problem/problem.hpp"
#include "run/prepare.hpp"
#include "run/settings_of.hpp"
#include "study/cases/case_file.hpp"

namespace keyblock::study {

/// The command line, before any file is read. Settings below override those above.
struct CaseRequest {
  std::vector<std::string> paths;  ///< the files of a case, or its folder
  std::string settings_file;       ///< empty: none
  std::string profile;             ///< empty: chosen by the settings file, the case file, or the kind of the files
  std::vector<Override> sets;      ///< of the command line
  formats::DrawingChoices choices = {};
};

/// The files and choices that a request stands for.
struct AskedCase {
  std::string name;                 ///< for tables
  std::filesystem::path folder;     ///< of the case; empty if files were given
  std::vector<std::string> files;   ///< to be read
  formats::DrawingChoices choices;  ///< for reading them
  CaseFile file;                    ///< empty if files were given
  std::string profile;              ///< of the command line or the settings file; empty: none
  std::vector<Override> common;     ///< of the settings file, then of the command line

  /// All settings of a run in that profile: those of `case.json`, then `common`.
  std::vector<Override> overrides(const std::string& under) const;
};

/// Reads `case.json` and the settings file. Throws InputError for a folder that holds no case or several, and for files
/// that cannot be read.
AskedCase asked_case(const CaseRequest& request);

/// Profile of a command for old files if neither a person nor a file names one.
enum class OldFiles { legacy, standard };

/// The profile of a run of the case: that asked for, else that of the case file, else by the kind of the files; but
/// `standard` if `case.json` says that `legacy` is not run. Throws UsageError if `case.json` says that it is not run.
ChosenProfile profile_for(const AskedCase& asked, const Problem& problem, OldFiles old_files = OldFiles::legacy);

/// A problem with the files and the mesh that settings name, and the settings that are left for `prepare`.
struct ConfiguredProblem {
  Problem problem;
  std::vector<Override> overrides;
};

/// Reads the files that settings name and puts settings of the mesh into the plan of covers, first those of the case
/// file. Throws InputError for a file that cannot be read and for a setting of the case file, std::invalid_argument for
/// an override.
ConfiguredProblem configured(Problem problem, const std::vector<Override>& overrides);

/// A case made ready for its first step.
struct PlannedCase {
  ChosenProfile profile;
  std::vector<Override> overrides;  ///< all settings that were asked for
  Problem problem;                  ///< with the files and the mesh that settings name, and the points of histories
  Prepared prepared;
  Warnings warnings;  ///< of preparing, then of looking ahead
};

/// The way of `run`, `check` and the library: profile, settings, scene, a look ahead. Throws as `profile_for`,
/// `configured`, `with_followed_points` and `prepare`.
PlannedCase planned(const AskedCase& asked, const Problem& problem);

}  // namespace keyblock::study
