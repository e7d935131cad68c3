// Makes command lines of sweeps, for tests.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "tests/support/program.hpp"

namespace keyblock::value_sweep_test {

using Words = std::vector<std::string>;

inline Words operator+(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// A block on a plane of 30 degrees, with a joint material named bedding.
inline std::string slope_in(const std::string& folder) {
  support::run_keyblock({"new", "block", "-o", folder + "/block.json"});
  return folder + "/block.json";
}

inline Words sweep_of(const std::string& file, const std::string& folder) {
  return {"sweep",  file,
          "--over", "/analysis/joint_materials/0/friction_angle_deg=10:25:5",
          "--over", "time_step=10 ms,5 ms",
          "--out",  "displacement,point1.dx,ledger.friction,/counts/blocks",
          "-o",     folder,
          "--jobs", "2"};
}

}  // namespace keyblock::value_sweep_test
