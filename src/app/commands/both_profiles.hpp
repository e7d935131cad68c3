// Compares the two runs of `run --both`: table, differences, known causes.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/exit_code.hpp"
#include "job/run_report.hpp"

namespace keyblock {

/// Result of the run under one profile.
struct ProfileAnswer {
  std::string profile;
  std::string folder;
  std::string refused;  ///< reason for not running it, with no values below; empty if it ran
  ExitCode code = ExitCode::ok;
  RunRecord record;
  Settings settings;
  std::size_t blocks = 0;
  double length = 0;   ///< half the greater extent of the scene
  double modulus = 0;  ///< greatest Young's modulus
};

/// Returns one sentence per quantity that differs by more than 1 % of the largest value of its kind. Differences below
/// round-off do not count: 1e-12 of the scene for displacements, 1e-12 of the modulus for stresses. If the runs end at
/// different times, displacements and stresses are not compared; the sentence gives the times.
std::vector<std::string> differences(const ProfileAnswer& one, const ProfileAnswer& other);

/// Returns one sentence per known cause of a difference.
std::vector<std::string> reasons(const ProfileAnswer& one, const ProfileAnswer& other);

/// Returns a table of two columns, then differences and causes; `units` are those of the case, or empty.
std::string side_by_side(const ProfileAnswer& one, const ProfileAnswer& other, const Units& units);
nlohmann::ordered_json side_by_side_json(const ProfileAnswer& one, const ProfileAnswer& other);

/// Returns the exit code of the first run; 1 if only the second failed.
ExitCode code_of_both(const ProfileAnswer& one, const ProfileAnswer& other);

}  // namespace keyblock
