// Settings that name a file: read where files may be read, and put into the problem.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "run/prepare.hpp"

namespace keyblock {

/// The value of a setting that stands in a file in `folder`: if it names a file, the path of that from the working
/// folder (an absolute name stays); else the value itself.
std::string from_folder(const std::filesystem::path& folder, const std::string& name, const std::string& value);

/// The problem with the table that the setting `body_acceleration_file` names, if one does: an override names it from
/// the working folder, the choices of a case file from the folder of that file, where the name becomes that from the
/// working folder. Throws InputError if the file is missing or wrong.
Problem with_named_files(Problem problem, const std::vector<Override>& overrides);

}  // namespace keyblock
