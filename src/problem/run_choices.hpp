// What a case file says about its run beside the scene: the units of its numbers, a profile, and settings on top of it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"

namespace keyblock {

/// The names of the base units; one consistent set, to which only drawings (DXF) are brought. Empty: the old file did
/// not say.
struct Units {
  std::string length;
  std::string mass;
  std::string time;

  bool operator==(const Units&) const = default;
};

struct RunChoices {
  std::string profile;                                        ///< empty: whatever the command takes
  std::vector<std::pair<std::string, std::string>> settings;  ///< name and value as `keyblock run --set` takes them

  Place place = {};
  Place profile_place = {};
  std::vector<Place> setting_places = {};  ///< one a setting; none where no file says them

  friend bool operator==(const RunChoices& a, const RunChoices& b) {
    return a.profile == b.profile && a.settings == b.settings;
  }
};

}  // namespace keyblock
