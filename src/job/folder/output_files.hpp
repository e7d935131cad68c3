// What a run writes into its folder by name: which names are its own, and what an earlier run left there.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "job/files.hpp"

namespace keyblock {

inline constexpr const char* kRecord = "run.json";
inline constexpr const char* kCheckpoint = "checkpoint.h5";
inline constexpr const char* kFrameList = "fields.pvd";
inline constexpr const char* kReactionFile = "reactions.svg";

class OutputFiles {
 public:
  /// Nothing is changed before `remove_earlier`. Throws UsageError where `folder` is a file.
  OutputFiles(std::filesystem::path folder, Overwrite overwrite);

  Overwrite overwrite() const { return overwrite_; }

  /// Throws UsageError where a run has written here that may not be overwritten.
  void require_free() const;

  /// Removes what an earlier run wrote, by its record. Throws UsageError where that is not possible.
  void remove_earlier();

  /// Removes what is written as a run goes.
  void remove_growing();

  /// Over the files of this process, and over others where that is allowed. Throws OutputError.
  void write(std::string_view file, const std::string& text);

  /// Another class has written it.
  void name(std::string_view file) { names_.emplace_back(file); }

  /// The names begin anew: they are in the same order whatever was written on the way.
  void forget_names() { names_.clear(); }

  bool is_own(std::string_view file) const { return own_.contains(std::string(file)); }

  /// In the order of writing.
  const std::vector<std::string>& names() const { return names_; }

 private:
  std::set<std::string> written_before() const;

  std::filesystem::path folder_;
  Overwrite overwrite_;  ///< of what stands there before; a run that goes on meets its own files
  std::vector<std::string> names_;
  std::set<std::string> own_;  ///< written by this process, and so its to write again
};

}  // namespace keyblock
