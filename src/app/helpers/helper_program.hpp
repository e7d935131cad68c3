// Starts a program of the system that converts files, in a folder of its own.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace keyblock {

/// Returns true if a folder of PATH holds the program, or if the path names one.
bool is_installed(const std::string& program);

/// Messages of a program: shown at the terminal, or dropped.
enum class Words { shown, dropped };

/// Runs the program to its end; returns its exit code, -1 if it did not start or a signal ended it.
int run_helper(std::vector<std::string> words, Words messages = Words::shown);

/// Fresh folder for the files of a conversion; removed with them.
class WorkFolder {
 public:
  /// Throws OutputError.
  explicit WorkFolder(const std::string& name);
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;
  ~WorkFolder();

  std::filesystem::path operator/(const char* name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

}  // namespace keyblock
