// Letters within brackets, longest first.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/declared_units.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "problem/units/unit_conversion.hpp"

namespace keyblock {
namespace {

constexpr double kRoundOff = 1e-12;
constexpr Dimension kForceDimension{1, 1, -2};

// With the prefix that the base units make.
std::string prefixed(const Units& units, const Dimension& dimension, std::string_view name, const std::string& spelt) {
  const std::optional<double> factor = si_factor(units, dimension);
  if (!factor) return {};
  constexpr std::array<std::pair<double, const char*>, 6> kFactors{
      {{1, ""}, {1e3, "k"}, {1e6, "M"}, {1e9, "G"}, {1e-3, "m"}, {1e-6, "µ"}}};
  for (const auto& [power, prefix] : kFactors)
    if (std::abs(*factor / power - 1) < kRoundOff) return fmt::format("{}{}", prefix, name);
  return spelt;
}

std::string replaced(std::string text, std::string_view what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
  return text;
}

std::string named(std::string text, const Units& units) {
  const std::string force = force_unit(units);
  const std::vector<std::pair<std::string_view, std::string>> names{
      {"[L]", units.length},
      {"[T]", units.time},
      {"[F]", force},
      {"[F L]", force.empty() || units.length.empty() ? "" : force + " " + units.length},
      {"[F/L²]", stress_unit(units)},
      {"[F per unit thickness]", force.empty() ? "" : fmt::format("{} per {} of thickness", force, units.length)},
      {"[F L per unit thickness]",
       force.empty() ? "" : fmt::format("{0} {1} per {1} of thickness", force, units.length)}};
  for (const auto& [letters, name] : names)
    if (!name.empty()) text = replaced(std::move(text), letters, fmt::format("[{}]", name));
  return text;
}

}  // namespace

std::string force_unit(const Units& units) {
  return prefixed(units, kForceDimension, "N", fmt::format("{} {}/{}²", units.mass, units.length, units.time));
}

std::string stress_unit(const Units& units) {
  return prefixed(units, kStress, "Pa", fmt::format("{}/({} {}²)", units.mass, units.length, units.time));
}

std::string table_in_units(std::string text, const Units& units) {
  if (units == Units{}) return text;
  const std::size_t end = text.find('\n');
  const std::string head = named(text.substr(0, end), units);
  return end == std::string::npos ? head : head + text.substr(end);
}

std::string picture_in_units(std::string text, const Units& units) {
  if (units == Units{}) return text;
  if (!units.length.empty()) text = replaced(std::move(text), "(unit of length of the input)", units.length);
  return named(std::move(text), units);
}

}  // namespace keyblock
