// Parses the values over which a sweep runs: of a key of the case, of a setting, or of statistics of joints.
// SPDX-License-Identifier: GPL-3.0-or-later
//
//   KEY=A,B,C            a list; a unit behind the last number belongs to all numbers without one: "0,50 kN". A key
//                        that takes names has the words as they are: "1.csv,2.csv"
//   KEY=FIRST:LAST:STEP  a range with both ends
//   KEY=normal(MEAN,DEVIATION)        also normal(MEAN,DEVIATION,LOW,HIGH), whose values lie between LOW and HIGH
//   KEY=lognormal(MEAN,DEVIATION)     of the value itself, not of its logarithm
//   KEY=uniform(LOW,HIGH), KEY=triangular(LOW,MODE,HIGH)
//
// KEY is a JSON pointer into the case file, `joints:` with a pointer into the joint statistics, or a setting.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "api/case_values.hpp"

namespace keyblock::study {

/// Prefix of a pointer into the joint statistics.
inline constexpr std::string_view kOfJoints = "joints:";

enum class Law { normal, lognormal, uniform, triangular };

struct Distribution {
  Law law = Law::uniform;
  std::vector<double> numbers;  ///< in the order above
  std::string unit = {};        ///< of the values; empty: none

  /// Returns the value below which a fraction `p` of all values lies, 0 < p < 1.
  double quantile(double p) const;
};

/// Returns a number as case files have it: whole numbers without a point.
nlohmann::ordered_json number_json(double number);

/// Key with its values, or with their distribution.
struct VariedKey {
  std::string key;
  std::vector<nlohmann::ordered_json> values = {};
  std::optional<Distribution> distribution = {};
};

/// Parses "KEY=VALUES". `words` returns the words that a key takes; without it all may be numbers with units. Throws
/// std::invalid_argument, with the text, if it has another form, or a value is null.
VariedKey varied_key_of(const std::string& text, const std::function<WordKind(const std::string& key)>& words = {});

}  // namespace keyblock::study
