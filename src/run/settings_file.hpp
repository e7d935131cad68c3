// Reads a file of settings: the values of `--set`, line by line, for use in many runs.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Layout: one `name = value` per line; `profile = NAME` at most once. Empty lines and lines that begin with # are
// ignored. A file that a value names is searched beside the settings file.
#pragma once

#include <string>
#include <vector>

#include "settings/settings_table.hpp"

namespace keyblock {

struct SettingsFile {
  std::string profile;  ///< empty if the file names none
  std::vector<Override> settings;
};

/// Returns the settings in `text`. `name`: of the file, for messages. Throws InputError with line and column for a line
/// without `=`, an unknown or repeated name, an unknown profile, or an invalid value.
SettingsFile read_settings(const std::string& name, const std::string& text);

/// Tries a single setting, of blocks or of the mesh of NMM bodies. Throws std::invalid_argument for an unknown name or
/// an invalid value.
void require_setting(const std::string& name, const std::string& value);

/// Returns the file's text, headed by `comment` (one line or several).
std::string settings_text(const SettingsFile& file, const std::string& comment);

}  // namespace keyblock
