// Writes the titles of pictures, and reads those of a completed run from its record.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "problem/run_choices.hpp"

namespace keyblock {

/// Returns "slope, profile standard", with the name of the first file of the case.
std::string title_of(const std::filesystem::path& file, const std::string& profile);

/// Returns "slope, profile standard, time 1.5 s".
std::string title_at(const std::string& title, double time, const Units& units);

/// Returns the entry "units" of a record. Names force and stress too, if the declared units determine them.
nlohmann::ordered_json units_json(const Units& units);

/// Returns the unit of each quantity whose units are declared, by its letters as the schema has them: "F/L²", and "F/L
/// of a slice" for one per unit thickness.
nlohmann::ordered_json units_by_letters(const Units& units);

struct RunHeading {
  std::string title;
  Units units = {};
  bool is_of_motion = true;        ///< as in `report::FieldPicture`
  std::vector<int> left_out = {};  ///< numbers, from 0, of elements that the pictures of the run leave out
  std::vector<int> held = {};      ///< numbers, from 0, of blocks with a fixed point
};

/// Reads the heading from run.json. A killed run has none; the title is then the name of the folder. Throws InputError
/// if the file is not a record.
RunHeading heading_of(const std::filesystem::path& folder);

}  // namespace keyblock
