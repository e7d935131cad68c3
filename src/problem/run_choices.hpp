// Holds the run options of a case file: the units of its numbers, a profile, and settings added to it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"

namespace keyblock {

/// Names of the base units; one consistent set, to which only drawings (DXF) are converted. Empty: not stated by the
/// old file.
struct Units {
  std::string length;
  std::string mass;
  std::string time;

  bool operator==(const Units&) const = default;
};

struct RunChoices {
  std::string profile;                                        ///< empty: that of the command
  std::vector<std::pair<std::string, std::string>> settings;  ///< name and value as for `keyblock run --set`

  Place place = {};
  Place profile_place = {};
  std::vector<Place> setting_places = {};  ///< one per setting; empty if no file sets them

  friend bool operator==(const RunChoices& a, const RunChoices& b) {
    return a.profile == b.profile && a.settings == b.settings;
  }
};

}  // namespace keyblock
