// `run --both`: what the two sets of rules make of one case, side by side, with what is known of why they differ.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/exit_code.hpp"
#include "job/run_report.hpp"

namespace keyblock {

/// What one profile came to.
struct ProfileAnswer {
  std::string profile;
  std::string folder;
  std::string refused;  ///< why it was not run; empty where it was, and nothing below is known otherwise
  ExitCode code = ExitCode::ok;
  RunRecord record;
  Settings settings;
  std::size_t blocks = 0;
  double length = 0;   ///< half the greater extent of the scene
  double modulus = 0;  ///< greatest Young's modulus
};

/// A sentence for each quantity that differs by more than a hundredth of the largest of its kind in either run; empty
/// if none does. Round-off is no difference: a displacement below 1e-12 of the scene, a stress below 1e-12 of the
/// modulus. Displacements and stresses of runs that end at different times are not compared; the sentence gives the
/// times.
std::vector<std::string> differences(const ProfileAnswer& one, const ProfileAnswer& other);

/// What is known of why, a sentence each.
std::vector<std::string> reasons(const ProfileAnswer& one, const ProfileAnswer& other);

/// A table of two columns, then differences and reasons; `units` are those of the case, or empty.
std::string side_by_side(const ProfileAnswer& one, const ProfileAnswer& other, const Units& units);
nlohmann::ordered_json side_by_side_json(const ProfileAnswer& one, const ProfileAnswer& other);

/// That of the first; where that is good and the other is not, 1.
ExitCode code_of_both(const ProfileAnswer& one, const ProfileAnswer& other);

}  // namespace keyblock
