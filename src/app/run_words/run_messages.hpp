// Prints the messages of a run on the terminal: one line at the start; summary, files and help at the end.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <set>
#include <string>

#include "job/run_report.hpp"
#include "run/prepare.hpp"

namespace keyblock {

/// Messages of one command. A warning is printed once, also if the command runs the case twice.
class RunMessages {
 public:
  /// Prints the first line and the warnings about the input. Notes follow in one line at the end.
  void print_start(const std::string& file, const Prepared& prepared, const RunRecord& record);

  /// Prints that a resumed run continues after `step`; none: it starts again, because no checkpoint was saved.
  void print_resumed(std::optional<int> step) const;

  /// Prints that the run was stopped before its first step.
  void print_stopped_early(const std::string& folder) const;

  /// Prints warnings, the summary, the files in `folder`, and help if the run failed or is unreliable.
  void print_end(const Prepared& prepared, const RunRecord& record, const std::string& folder);

 private:
  void print_warnings(const RunRecord& record, bool with_notes);
  void print_failure(const Prepared& prepared, const RunOutcome& outcome) const;
  void print_doubts(const Warnings& doubts) const;
  void print_stop(int steps, const std::string& folder) const;

  std::string file_;
  std::set<std::string> printed_;  ///< warnings printed in full
};

}  // namespace keyblock
