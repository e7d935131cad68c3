// Turns a request for a case (files or a folder, settings, profile) into its files and choices, and reads them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "api/case_file.hpp"
#include "api/case_values.hpp"
#include "formats/case.hpp"
#include "run/settings_of.hpp"

namespace keyblock {

/// Request for a case, before any file is read. Settings of later members override those of earlier ones.
struct CaseRequest {
  std::vector<std::string> paths;  ///< the files of a case, or its folder
  std::string settings_file;       ///< empty: none
  std::string profile;             ///< empty: chosen by the settings file, the case file, or the kind of the files
  std::vector<Override> sets;      ///< of the command line, or of a caller
  formats::DrawingChoices choices = {};
  std::vector<ChangedValue> values = {};  ///< of the case file, changed after reading
};

/// Files and choices of a request.
struct AskedCase {
  std::string name;                 ///< for tables
  std::filesystem::path folder;     ///< of the case; empty if files were given
  std::vector<std::string> files;   ///< to be read
  formats::DrawingChoices choices;  ///< for reading them
  CaseFile file;                    ///< empty if files were given
  std::string profile;              ///< of the command line or the settings file; empty: none
  std::vector<Override> common;     ///< of the settings file, then of the command line
  std::vector<ChangedValue> values;    ///< of the case file, changed after reading

  /// Returns all settings of a run in that profile: those of `case.json`, then `common`.
  std::vector<Override> overrides(const std::string& under) const;
};

/// Reads `case.json` and the settings file. Throws InputError for a folder that holds no case or several, and for files
/// that cannot be read.
AskedCase asked_case(const CaseRequest& request);

/// Case whose files were read.
struct OpenCase : AskedCase {
  formats::Case input;
  std::vector<formats::FileReading> unchanged_files = {};  ///< before values were changed; empty if none were

  /// Returns the files as they are on the disk.
  const std::vector<formats::FileReading>& read_files() const;
};

/// Changes values of an open case, after those that were changed before. Throws like `with_values`.
void change_values(OpenCase& open, const std::vector<ChangedValue>& values);

/// Reads the files of the case and changes the requested values. Throws InputError like `formats::load_case`, and like
/// `with_values`.
OpenCase opened(AskedCase asked);

}  // namespace keyblock
