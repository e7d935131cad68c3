// Settings that name a file: read where files may be read, and put into the problem.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "run/prepare.hpp"

namespace keyblock::study {

/// The problem with the table that the setting `body_acceleration_file` names, if one does: an override takes the name
/// from `folder`, the choices of a case file from the folder of that file, where the name becomes that from the folder
/// at hand; an absolute name stays. Throws InputError where the file is missing or wrong.
Problem with_named_files(Problem problem, const std::vector<Override>& overrides, const std::filesystem::path& folder);

}  // namespace keyblock::study
