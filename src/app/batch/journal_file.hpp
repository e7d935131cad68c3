// Appends lines to a journal, and reports the progress of jobs.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <string>

namespace keyblock {

/// Opens a journal at its end. A line is written by one call, so that a sudden end damages at most the last one. Throws
/// OutputError.
class JournalFile {
 public:
  explicit JournalFile(const std::filesystem::path& file);
  ~JournalFile();
  JournalFile(const JournalFile&) = delete;
  JournalFile& operator=(const JournalFile&) = delete;

  void add(const std::string& line) const;

 private:
  std::string name_;
  int descriptor_;
};

/// Reports the progress of jobs every few seconds, and the time left if the other jobs take as long.
class JobReports {
 public:
  explicit JobReports(std::size_t jobs) : jobs_(jobs) {}
  void add_one();

 private:
  using Clock = std::chrono::steady_clock;

  std::size_t jobs_;
  std::size_t done_ = 0;
  Clock::time_point begun_ = Clock::now();
  Clock::time_point shown_ = begun_;
};

}  // namespace keyblock
