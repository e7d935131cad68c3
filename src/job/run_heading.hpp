// What pictures say of a run, and the same of a run that is over, from its record.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "problem/run_choices.hpp"

namespace keyblock {

/// "slope, profile standard", of the first file of the case.
std::string title_of(const std::filesystem::path& file, const std::string& profile);

/// "slope, profile standard, time 1.5 s".
std::string title_at(const std::string& title, double time, const Units& units);

struct RunHeading {
  std::string title;
  Units units = {};
  bool is_of_motion = true;        ///< as `report::FieldPicture` has it
  std::vector<int> left_out = {};  ///< numbers, from 0, of elements that the pictures of the run leave out
  std::vector<int> held = {};      ///< likewise of blocks with a fixed point
};

/// From run.json; of a run that was killed, which has none, the name of the folder. Throws InputError where the file is
/// no record.
RunHeading heading_of(const std::filesystem::path& folder);

}  // namespace keyblock
