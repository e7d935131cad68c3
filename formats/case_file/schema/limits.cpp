// Writes the ends of a range as keys of a JSON schema.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/case_file/schema/limits.hpp"

#include <cmath>

namespace keyblock::formats {
namespace {

// A whole number stays one.
nlohmann::ordered_json plain(double value) {
  if (value == std::floor(value) && std::abs(value) < 1e15) return static_cast<long long>(value);
  return value;
}

}  // namespace

void put_limits(nlohmann::ordered_json& schema, const Range& range) {
  if (range.is_bounded_below()) schema[range.open_below ? "exclusiveMinimum" : "minimum"] = plain(range.least);
  if (range.is_bounded_above()) schema[range.open_above ? "exclusiveMaximum" : "maximum"] = plain(range.greatest);
}

}  // namespace keyblock::formats
