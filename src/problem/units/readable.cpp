// Table of units that differ by a prefix alone.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/units/readable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/words/plain_number.hpp"

namespace keyblock {
namespace {

constexpr int kDigits = 3;
constexpr double kLargest = 1e5;  // from here on a power of ten is written

/// Unit, its size, and the least number that is written in it; 0 for the smallest of its kind, which comes last.
struct Prefixed {
  std::string_view name;
  double size;
  double least;
};

// page/src/draw/numbers.ts has the same table: a test of the page compares the two.
constexpr std::array kPrefixed = std::to_array<Prefixed>(
    {{"m", 1, 0.1},    {"mm", 1e-3, 0.01}, {"µm", 1e-6, 0}, {"m/s", 1, 0.1},  {"mm/s", 1e-3, 0.01}, {"µm/s", 1e-6, 0},
     {"s", 1, 0.1},    {"ms", 1e-3, 0},    {"GPa", 1e9, 1}, {"MPa", 1e6, 1},  {"kPa", 1e3, 1},      {"Pa", 1, 0},
     {"MN", 1e6, 1},   {"kN", 1e3, 1},     {"N", 1, 0},     {"MN/m", 1e6, 1}, {"kN/m", 1e3, 1},     {"N/m", 1, 0},
     {"MJ/m", 1e6, 1}, {"kJ/m", 1e3, 1},   {"J/m", 1, 0}});

/// Returns the row of a unit. An energy is spelt as force times length, "kN·m/m", and its prefixes are those of "J/m".
auto row_of(std::string_view unit) {
  constexpr std::string_view kWork = "N·m/";
  std::string name(unit);
  if (const std::size_t at = unit.find(kWork); at != std::string_view::npos)
    name = fmt::format("{}J/{}", unit.substr(0, at), unit.substr(at + kWork.size()));
  return std::ranges::find(kPrefixed, name, &Prefixed::name);
}

std::string digits_of(double value) {
  return std::abs(value) < kLargest ? plain(value, kDigits) : fmt::format("{:.{}g}", value, kDigits);
}

}  // namespace

std::string Scaled::label(std::string_view name) const {
  return unit.empty() ? std::string(name) : fmt::format("{} [{}]", name, unit);
}

Scaled scaled_unit(double largest, const Measure& measure, const Units& units) {
  const std::string unit = unit_of(measure, units);
  const auto own = row_of(unit);
  if (!(largest > 0) || own == kPrefixed.end() || !is_declared(measure, units)) return {1, unit};
  auto best = own;
  while (best != kPrefixed.begin() && std::prev(best)->least > 0) --best;
  while (largest * own->size < best->least * best->size) ++best;
  return {own->size / best->size, std::string(best->name)};
}

std::string readable(double value, const Measure& measure, const Units& units) {
  if (!is_declared(measure, units)) return digits_of(value);
  const Scaled scaled = scaled_unit(std::abs(value), measure, units);
  return scaled.unit.empty() ? digits_of(value) : fmt::format("{} {}", digits_of(value * scaled.factor), scaled.unit);
}

}  // namespace keyblock
