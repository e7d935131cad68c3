// Makes the report of a search for the factor of safety from its record.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "app/handout/handout.hpp"
#include "app/handout/record_reading.hpp"

namespace keyblock {

inline constexpr const char* kStrengthRecord = "fos.json";

/// Record of a search for the factor of safety.
class StrengthRecord : public ResultRecord {
 public:
  /// Throws InputError if the folder has no such record.
  explicit StrengthRecord(const std::filesystem::path& folder);

  report::Verdict verdict() const;
  /// Returns "at least 1", "below 1" or "not found", about the factor.
  std::string_view state() const;
  /// Returns "Factor of safety 3.29: stable at 3.284, unstable at 3.29.", or why the search found no factor.
  std::string words() const;
  std::string program() const;
};

/// Returns the pictures of the search that exist.
std::vector<report::DocumentPicture> strength_pictures(const std::filesystem::path& folder, std::size_t most = 2);

/// Returns what the program warned of.
report::DocumentSection warning_section(const StrengthRecord& record);

/// Returns the report: factor, bracket, pictures of its ends, trials, materials, notes, warnings, checksums. A factor
/// below 1 is bad.
Handout strength_document(const std::filesystem::path& folder, const std::string& project);

}  // namespace keyblock
