// Makes the report of a search for the factor of safety from its record.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "app/handout/handout.hpp"

namespace keyblock {

inline constexpr const char* kStrengthRecord = "fos.json";

/// Record of a search for the factor of safety.
class StrengthRecord {
 public:
  /// Throws InputError if the folder has no such record.
  explicit StrengthRecord(const std::filesystem::path& folder);

  const nlohmann::ordered_json& json() const { return json_; }
  report::Verdict verdict() const;
  /// Returns "Factor of safety 3.29: stable at 3.284, unstable at 3.29.", or why the search found no factor.
  std::string words() const;
  std::string program() const;

 private:
  nlohmann::ordered_json json_;
};

/// Returns the pictures of the search that exist.
std::vector<report::DocumentPicture> strength_pictures(const std::filesystem::path& folder, std::size_t most = 2);

/// Returns the report: factor, bracket, pictures of its ends, trials, notes, warnings. A factor below 1 is bad.
Handout strength_document(const std::filesystem::path& folder, const std::string& project);

}  // namespace keyblock
