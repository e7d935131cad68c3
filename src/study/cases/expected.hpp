// Reads the expected values of a case: the rows of expected.csv.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Columns: quantity,block,time,value,tolerance,tolerance_reason,source and two optional ones. judged: `both` (as
// without the column), `legacy` or `standard`, the profile whose value is compared with the tolerance. listed_miss:
// reason of a known miss of a benchmark, empty otherwise.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace keyblock::study {

struct ExpectedValue {
  std::string quantity;
  std::optional<int> block;  ///< or measured point, from 1, as in the file; empty for the whole scene
  double time = 0;
  double value = 0;
  double tolerance = 0;  ///< absolute
  std::string tolerance_reason;
  std::string source;
  std::string judged = "both";
  std::string listed_miss;  ///< reason of a published miss; a value within its tolerance is then unexpected

  /// Returns true if the value is judged under `rules`: legacy or standard.
  bool is_judged_in(const std::string& rules) const { return judged == "both" || judged == rules; }
};

/// Relative tolerance above which a value only shows whether something happens, not how far it goes. No error is
/// measured against it.
inline constexpr double kVerdict = 0.2;
std::vector<ExpectedValue> without_verdicts(std::vector<ExpectedValue> expected);

/// Reads the table. Throws InputError for an unreadable table, an unknown quantity, or an unknown profile.
std::vector<ExpectedValue> read_expected(const std::filesystem::path& file);

}  // namespace keyblock::study
