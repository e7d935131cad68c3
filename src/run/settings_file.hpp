// A file of settings: what `--set` says, line by line, to be kept and given to many runs.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Layout: one `name = value` a line; `profile = NAME` at most once; lines that begin with # and empty lines are passed
// over. A file that a value names is looked for beside the settings file.
#pragma once

#include <string>
#include <vector>

#include "settings/settings_table.hpp"

namespace keyblock {

struct SettingsFile {
  std::string profile;  ///< empty: the file names none
  std::vector<Override> settings;
};

/// `name`: of the file, for messages. Throws InputError with line and column for a line without `=`, a name that is no
/// setting or comes twice, a profile that is none, or a value that its setting does not take.
SettingsFile read_settings(const std::string& name, const std::string& text);

/// Tries a setting by itself, of blocks or of the mesh of bodies on covers. Throws std::invalid_argument for a name
/// that is none, or a value that its setting does not take.
void require_setting(const std::string& name, const std::string& value);

/// The file's text, headed by `comment` (one line or several).
std::string settings_text(const SettingsFile& file, const std::string& comment);

}  // namespace keyblock
