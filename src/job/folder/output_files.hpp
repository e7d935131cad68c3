// Tracks the files of a run by name: its own ones, and those that an earlier run left in the folder.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "job/files.hpp"
#include "job/folder/made_by.hpp"

namespace keyblock {

inline constexpr const char* kRecord = "run.json";
inline constexpr const char* kCheckpoint = "checkpoint.h5";
inline constexpr const char* kFrameList = "fields.pvd";
inline constexpr const char* kReactionFile = "reactions.svg";
inline constexpr const char* kPageFile = "page.html";

class OutputFiles {
 public:
  /// Changes nothing on the disk before `remove_earlier`. Throws UsageError if `folder` is a file.
  OutputFiles(std::filesystem::path folder, Overwrite overwrite);

  Overwrite overwrite() const { return overwrite_; }

  /// Throws UsageError if a run has written here that may not be overwritten.
  void require_free() const;

  /// Removes the files of an earlier run, by its record. Throws UsageError if that is not possible.
  void remove_earlier();

  /// Removes the tables that grow during a run.
  void remove_growing();

  /// Writes over the files of this process, and over others if that is permitted. Throws OutputError.
  void write(std::string_view file, const std::string& text);

  /// Records a file that another class writes, with the checksum of its bytes.
  void name(std::string_view file, std::string checksum);

  /// Clears the names, so that their order does not depend on files written during the run.
  void forget_names() { names_.clear(); }

  bool is_own(std::string_view file) const { return own_.contains(std::string(file)); }

  /// Returns the checksums of the named files as written, in that order. The page, which follows the record, has none.
  /// Throws OutputError if a file is gone.
  Checksums checksums() const;

  /// Returns the names in the order of writing.
  const std::vector<std::string>& names() const { return names_; }

 private:
  std::set<std::string> written_before() const;

  std::filesystem::path folder_;
  Overwrite overwrite_;  ///< of files that existed before; a resumed run meets its own files
  std::vector<std::string> names_;
  std::map<std::string, std::string> checksums_;  ///< by name
  std::set<std::string> own_;                     ///< written by this process, which may write them again
};

}  // namespace keyblock
