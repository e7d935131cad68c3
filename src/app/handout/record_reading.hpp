// Reads the records of results, run.json and fos.json, for reports.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "problem/units/measure.hpp"

namespace keyblock {

/// The record of a result. A missing value reads as empty text, or as null.
class ResultRecord {
 public:
  const nlohmann::ordered_json& json() const { return json_; }
  /// Returns the value at a path of keys, "outcome.motion.state"; null if there is none.
  const nlohmann::ordered_json& at(std::string_view path) const;
  /// Returns the list at a path; an empty one if there is none.
  const nlohmann::ordered_json& list(std::string_view path) const;
  std::string text(std::string_view path) const;
  /// Returns the number with its declared unit of a readable size, "1.52 mm"; empty if there is none.
  std::string quantity(std::string_view path, const Measure& measure) const;
  const Units& units() const { return units_; }
  /// Returns the unit that the record names for a path, or nothing.
  std::string unit_of(const std::string& path) const;

 protected:
  /// Throws InputError if `file` is no JSON object with this key; `what` names the expected record.
  ResultRecord(const std::filesystem::path& file, const char* key, const char* what);

 private:
  nlohmann::ordered_json json_;
  Units units_;
};

class RunRecordFile : public ResultRecord {
 public:
  /// Throws InputError if the folder has no record of a run, or another file of that name.
  explicit RunRecordFile(const std::filesystem::path& folder);
};

/// Returns the value under a key; null if there is none, or `of` has no keys.
const nlohmann::ordered_json& member(const nlohmann::ordered_json& of, const char* key);

/// Returns a value as a reader wants it: text bare, numbers with six digits, yes and no.
std::string plain_text(const nlohmann::ordered_json& value);

}  // namespace keyblock
