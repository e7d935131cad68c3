// Lists every setting with its permitted values, its value in each profile, and the dynamics that reads it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace keyblock {

/// Returns a table, one line per setting.
std::string settings_guide();

/// Returns the same as JSON: an array of name, group, meaning, permitted, read_by and the value in each profile.
std::string settings_json();

}  // namespace keyblock
