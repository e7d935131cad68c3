// Reads the criterion, and compares it with followed values.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/follow/stop_criterion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "problem/units/measure.hpp"

namespace keyblock {
namespace {

constexpr std::string_view kLength = "displacement";
constexpr std::array<std::pair<std::string_view, std::string_view>, 6> kShort{{{"d", kLength},
                                                                               {"dx", "displacement_x"},
                                                                               {"dy", "displacement_y"},
                                                                               {"vx", "velocity_x"},
                                                                               {"vy", "velocity_y"},
                                                                               {"r", "rotation"}}};

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(' ');
  return first == std::string::npos ? std::string() : text.substr(first, text.find_last_not_of(' ') + 1 - first);
}

std::optional<double> plain_number(const std::string& text) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(number)) return std::nullopt;
  return number;
}

double limit_of(const std::string& text, const std::string& quantity, const Units& units) {
  if (const auto number = plain_number(text)) return *number;
  const bool is_length = quantity.starts_with(kLength), is_speed = quantity.starts_with("velocity");
  if (is_length || is_speed)
    if (const auto [number, lacks] = converted(text, is_length ? measures::kLength : measures::kVelocity, units);
        number)
      return *number;
  throw std::invalid_argument(
      fmt::format("expected a number, or a length or velocity with its unit, found \"{}\"", text));
}

}  // namespace

std::string long_quantity(const std::string& name) {
  const auto found = std::ranges::find(kShort, name, &std::pair<std::string_view, std::string_view>::first);
  return found == kShort.end() ? name : std::string(found->second);
}

StopCriterion stop_criterion_of(const std::string& text, const Units& units) {
  const std::size_t sign = text.find_first_of("<>");
  const std::string quantity = trimmed(text.substr(0, sign));
  const std::size_t dot = quantity.rfind('.');
  if (sign == std::string::npos || dot == std::string::npos || dot == 0 || dot + 1 == quantity.size())
    throw std::invalid_argument(fmt::format("expected NAME.QUANTITY>VALUE, such as crest.dx>0.05, found \"{}\"", text));
  StopCriterion criterion{text, quantity.substr(0, dot), quantity.substr(dot + 1), text[sign] == '>', 0};
  criterion.quantity = long_quantity(criterion.quantity);
  criterion.limit = limit_of(trimmed(text.substr(sign + 1)), criterion.quantity, units);
  return criterion;
}

std::string StopCriterion::met_by(const std::vector<FollowedValue>& values) const {
  std::vector<std::string> there;
  std::optional<double> value;
  std::string unit;
  double squares = 0;
  for (const FollowedValue& one : values) {
    there.push_back(fmt::format("{}.{}", one.name, one.quantity));
    if (one.name != history) continue;
    const bool is_part = quantity == kLength && (one.quantity == "displacement_x" || one.quantity == "displacement_y");
    if (is_part) squares += one.value * one.value;
    if (!is_part && one.quantity != quantity) continue;
    value = is_part ? std::sqrt(squares) : one.value;
    unit = one.unit.empty() ? "" : " " + one.unit;
  }
  if (!value)
    throw InputError(
        {FileName::of_choice("stop-when", words)},
        fmt::format("expected a quantity of a history, found {}.{}; there are {}", history, quantity,
                    there.empty() ? std::string("none, add --history") : fmt::format("{}", fmt::join(there, ", "))));
  if (is_above ? *value <= limit : *value >= limit) return {};
  return fmt::format("{}.{} is {:.4g}{unit}, {} {:.4g}{unit}", history, quantity, *value, is_above ? "above" : "below",
                     limit, fmt::arg("unit", unit));
}

}  // namespace keyblock
