// A table that a run appends to as it goes, and cuts back to what its checkpoint knows of where it goes on.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <set>
#include <string>

namespace keyblock {

/// Lines begin with the number of their step. The file is there from the first row on.
class GrowingTable {
 public:
  GrowingTable(std::filesystem::path file, std::string header) : file_(std::move(file)), header_(std::move(header)) {}

  const std::filesystem::path& file() const { return file_; }
  bool has_begun() const { return has_begun_; }

  /// Whole lines; nothing for none. Throws OutputError.
  void append(const std::string& rows);

  /// Of a table that another process of the same run may have written: leaves the rows of these steps alone.
  void keep_steps(const std::set<int>& steps);
  /// The rows up to a step.
  void keep_until(int last_step);

  /// Throws OutputError.
  void flush() const;

 private:
  void keep(const std::function<bool(int)>& is_kept);

  std::filesystem::path file_;
  std::string header_;
  bool has_begun_ = false;
};

}  // namespace keyblock
