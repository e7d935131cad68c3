// Keeps the journal of a batch: one line per finished job, from which a stopped batch continues.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// journal.jsonl has one JSON object per line: first {"batch": 1, "task": "…"}, then {"row": {…}, "seconds": 0.1} per
// job. Only complete lines count; a last line cut short by a sudden end is ignored.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "report/catalogue_page.hpp"

namespace keyblock::study {

struct Journal {
  std::string task;                                  ///< request for every job; empty if the first line is missing
  std::map<std::string, report::CatalogueRow> rows;  ///< by job; of several lines the last
  std::string lines;                                 ///< complete lines, rewritten without an incomplete last one

  /// Adds a line that `journal_line` made.
  void add(std::string_view line);
  /// Returns the row of a job of that name on the same files, by path and checksum; null without one.
  const report::CatalogueRow* find(const std::string& name, const std::vector<report::CatalogueFile>& files) const;
};

std::string journal_head(const std::string& task);

/// Returns the line with a line break at the end. Bytes that are not UTF-8 are replaced.
std::string journal_line(const report::CatalogueRow& row, double seconds);

Journal read_journal(std::string_view text);

}  // namespace keyblock::study
