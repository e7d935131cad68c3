// Tries the condition at each number of its wording, and at a value on both sides of it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/case_file/schema/limits.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace keyblock::formats {
namespace {

std::vector<double> numbers_in(std::string_view wording) {
  std::vector<double> numbers;
  for (std::size_t at = 0; at < wording.size();) {
    std::size_t from = wording.find_first_of("0123456789", at);
    if (from == std::string_view::npos) break;
    const std::size_t end = std::min(wording.find_first_not_of("0123456789.e-", from), wording.size());
    if (from > 0 && wording[from - 1] == '-') --from;
    numbers.push_back(std::stod(std::string(wording.substr(from, end - from))));
    at = end;
  }
  return numbers;
}

// A whole number stays one.
nlohmann::ordered_json plain(double value) {
  if (value == std::floor(value) && std::abs(value) < 1e15) return static_cast<long long>(value);
  return value;
}

}  // namespace

void put_limits(nlohmann::ordered_json& schema, std::string_view wording, const std::function<bool(double)>& holds) {
  for (const double limit : numbers_in(wording)) {
    const bool is_in = holds(limit);
    // A small share of the limit, or one for conditions that take whole numbers alone.
    const auto beside = [&](double sign) {
      return holds(limit + sign) || holds(limit + sign * 1e-6 * std::max(1e-3, std::abs(limit)));
    };
    const bool above = beside(1), below = beside(-1);
    if (above && !below) schema[is_in ? "minimum" : "exclusiveMinimum"] = plain(limit);
    if (below && !above) schema[is_in ? "maximum" : "exclusiveMaximum"] = plain(limit);
  }
}

}  // namespace keyblock::formats
