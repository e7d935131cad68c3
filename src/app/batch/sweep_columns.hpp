// Describes the columns of the table of a sweep: units and plain words, for columns.csv and the picture.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "problem/run_choices.hpp"
#include "study/sweep/sweep_table.hpp"

namespace keyblock {

struct SweepColumn {
  std::string name;   ///< as in table.csv
  std::string unit;   ///< of all values; empty: none, several in texts, or not declared by the case
  std::string words;  ///< "friction angle of joint material 1"

  /// Returns the words with the unit in brackets.
  std::string label() const { return unit.empty() ? words : words + " [" + unit + "]"; }
};

/// Number of a value, and the unit behind a blank; no number for other values.
struct SweptAmount {
  double number = std::nan("");
  std::string unit = {};
};

SweptAmount amount_of(const nlohmann::ordered_json& value);

/// Describes keys and outputs, in the order of the table. `case_text`: the case file in strict JSON.
std::vector<SweepColumn> sweep_columns(const study::SweepTable& table, const std::string& case_text,
                                       const Units& units);

/// Returns columns.csv: column, unit, meaning, for all columns of table.csv.
std::string columns_csv(const std::vector<SweepColumn>& columns);

}  // namespace keyblock
