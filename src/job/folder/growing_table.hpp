// Appends rows to a table during a run. A resumed run cuts the table back to the state of its checkpoint.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
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

  /// Appends whole lines; does nothing if there are none. The first ones reach the file at once, later ones in lots:
  /// at the latest with the first rows after a quarter of a second. Throws OutputError.
  void append(const std::string& rows);

  /// Writes the rows that wait in memory. Throws OutputError.
  void write_waiting();

  /// Returns the checksum of all rows so far, those that wait included.
  std::string checksum() const { return digest_.text(); }

  /// Saves size and checksum of the rows written so far. Restoring throws InputError if the file no longer begins with
  /// them.
  void describe(Archive& archive);

  /// Removes rows written after `describe`, or the whole file if nothing was restored.
  void drop_what_followed();

  /// Writes the waiting rows and flushes the file to the disk. Throws OutputError.
  void flush();

 private:
  void count(const std::string& bytes);

  std::filesystem::path file_;
  std::string header_;
  std::string waiting_;   ///< rows not yet in the file
  std::size_t size_ = 0;  ///< bytes, those that wait included
  Sha256 digest_;         ///< of these bytes
  std::chrono::steady_clock::time_point written_{};
};

}  // namespace keyblock
