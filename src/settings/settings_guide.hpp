// What a user may set: every setting with its permitted values, its value in each profile, and who reads it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace keyblock {

/// A table, one line a setting.
std::string settings_guide();

/// The same as JSON: an array of name, group, meaning, permitted, read_by and the value in each profile.
std::string settings_json();

}  // namespace keyblock
