// Appends rows to a table during a run. A resumed run cuts the table back to the state of its checkpoint.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>

#include "base/archive.hpp"
#include "base/bytes/sha256.hpp"

namespace keyblock {

/// Table file that exists from its first row on.
class GrowingTable {
 public:
  GrowingTable(std::filesystem::path file, std::string header) : file_(std::move(file)), header_(std::move(header)) {}

  const std::filesystem::path& file() const { return file_; }
  bool has_begun() const { return size_ > 0; }

  /// Appends whole lines; does nothing if there are none. Throws OutputError.
  void append(const std::string& rows);

  /// Saves size and checksum of the rows written so far. Restoring throws InputError if the file no longer begins with
  /// them.
  void describe(Archive& archive);

  /// Removes rows written after `describe`, or the whole file if nothing was restored.
  void drop_what_followed();

  /// Flushes the file to the disk. Throws OutputError.
  void flush() const;

 private:
  void count(const std::string& bytes);

  std::filesystem::path file_;
  std::string header_;
  std::size_t size_ = 0;  ///< bytes written
  Sha256 digest_;         ///< of the bytes written
};

}  // namespace keyblock
