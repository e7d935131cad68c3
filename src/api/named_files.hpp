// Reads files that settings name, and puts their content into the problem.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "run/prepare.hpp"

namespace keyblock {

/// Returns true for a setting whose value is the name of a file.
bool names_a_file(const std::string& setting);

/// Returns the value of a setting read from a file in `folder`. If it names a file, returns its path from the working
/// folder (an absolute name stays); otherwise the value itself.
std::string from_folder(const std::filesystem::path& folder, const std::string& name, const std::string& value);

/// Returns the values of settings that name files.
std::vector<std::string> named_files(const std::vector<Override>& settings);

/// Returns the problem with the table of the file in the setting `body_acceleration_file`, if there is one. An override
/// names it relative to the working folder. A case file names it relative to its own folder; the name is then changed
/// to that from the working folder. Throws InputError if the file is missing or wrong.
Problem with_named_files(Problem problem, const std::vector<Override>& overrides);

/// Names files of settings relative to another folder, as a case file there has to. Absolute names stay.
void name_files_from(const std::filesystem::path& folder, RunChoices& choices);

}  // namespace keyblock
