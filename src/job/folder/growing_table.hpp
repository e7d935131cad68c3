// A table that a run appends to as it goes, and cuts back to what its checkpoint knows if the run goes on.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>

#include "base/archive.hpp"
#include "base/bytes/sha256.hpp"

namespace keyblock {

/// The file is there from the first row on.
class GrowingTable {
 public:
  GrowingTable(std::filesystem::path file, std::string header) : file_(std::move(file)), header_(std::move(header)) {}

  const std::filesystem::path& file() const { return file_; }
  bool has_begun() const { return size_ > 0; }

  /// Whole lines; nothing for none. Throws OutputError.
  void append(const std::string& rows);

  /// Size and checksum of what was written so far. Restoring throws InputError if the file no longer begins with that.
  void describe(Archive& archive);

  /// Removes what was written after `describe`, or all of the file if nothing was restored.
  void drop_what_followed();

  /// Throws OutputError.
  void flush() const;

 private:
  void count(const std::string& bytes);

  std::filesystem::path file_;
  std::string header_;
  std::size_t size_ = 0;  ///< bytes written
  Sha256 digest_;         ///< of them
};

}  // namespace keyblock
