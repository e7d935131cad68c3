// The expected values of a case: the rows of expected.csv.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Columns: quantity,block,time,value,tolerance,tolerance_reason,source and, where wanted, judged: `both` (as without
// the column), `legacy` or `standard`, the profile whose value is held against the tolerance; and listed_miss: why a
// benchmark is known not to be met, empty where it is.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace keyblock::study {

struct ExpectedValue {
  std::string quantity;
  std::optional<int> block;  ///< or measured point, from 1, as in the file; none for the whole scene
  double time = 0;
  double value = 0;
  double tolerance = 0;  ///< absolute
  std::string tolerance_reason;
  std::string source;
  std::string judged = "both";
  std::string listed_miss;  ///< a miss that is published with this reason; to hold is then the surprise

  /// `rules`: legacy or standard.
  bool is_judged_in(const std::string& rules) const { return judged == "both" || judged == rules; }
};

/// A value whose tolerance is so great a share of it says whether something happens, not how far it goes: no error is
/// measured against it.
inline constexpr double kVerdict = 0.2;
std::vector<ExpectedValue> without_verdicts(std::vector<ExpectedValue> expected);

/// Throws InputError for a table that cannot be read, a quantity that is none, or a profile that is none.
std::vector<ExpectedValue> read_expected(const std::filesystem::path& file);

}  // namespace keyblock::study
