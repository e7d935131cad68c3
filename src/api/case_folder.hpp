// Finds case folders: those below the given ones that hold expected values or a reference trace.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace keyblock {

/// Case folder: `NAME/NAME.json`, a case file; or `NAME/NAME.geo` or `.blk`, and `NAME/NAME.ana` or `.df`; and
/// `expected.csv` or `steps.csv` with `blocks.csv`.
struct CaseFolder {
  std::filesystem::path folder;
  std::string name;  ///< the folder as requested, for tables
  bool has_expected = false;
  bool has_trace = false;

  std::vector<std::string> inputs() const;
};

/// Returns the full path of the folder, which has a name even if the folder is ".".
std::filesystem::path whole_path(const std::filesystem::path& folder);

/// Returns the cases at or below each path, sorted by name. Throws InputError for a path without any.
std::vector<CaseFolder> find_cases(const std::vector<std::string>& paths);

/// Returns the case at a path, or the one below it. Throws InputError if there are several, or none.
CaseFolder the_case_in(const std::string& path);

}  // namespace keyblock
