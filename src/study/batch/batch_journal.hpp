// The journal of a batch: one line a finished job, from which a stopped batch goes on.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// journal.jsonl, one JSON object a line: {"batch": 1, "task": "…"} first, then {"row": {…}, "seconds": 0.1} a job. A
// line counts when it is whole; what a sudden end left of the last one is no line.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "report/catalogue_page.hpp"

namespace keyblock::study {

struct Journal {
  std::string task;  ///< what was asked of every job; empty where the first line is missing
  std::map<std::string, report::CatalogueRow> rows;  ///< by job; of several lines the last
  std::string lines;                                 ///< the whole lines, to be written again without the torn one

  /// Takes in a line that `journal_line` made.
  void add(std::string_view line);
  /// The row of a job of that name done on the same files, by path and checksum; null where there is none.
  const report::CatalogueRow* find(const std::string& name, const std::vector<report::CatalogueFile>& files) const;
};

std::string journal_head(const std::string& task);

/// With a line break at the end. Bytes that are no UTF-8 are replaced.
std::string journal_line(const report::CatalogueRow& row, double seconds);

Journal read_journal(std::string_view text);

}  // namespace keyblock::study
