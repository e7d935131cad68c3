// A row for each kind of quantity, its units in rising order.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/drawing/readable.hpp"

#include <fmt/format.h>

#include <array>
#include <span>

#include "problem/units/unit_conversion.hpp"

namespace keyblock::report {
namespace {

constexpr double kShort = 1000;
constexpr double kLong = 0.1;

using Names = std::span<const std::string_view>;

Names names_of(const Measure& measure) {
  static constexpr std::array<std::string_view, 2> kLengths{"mm", "m"};
  static constexpr std::array<std::string_view, 2> kTimes{"ms", "s"};
  static constexpr std::array<std::string_view, 4> kStresses{"Pa", "kPa", "MPa", "GPa"};
  static constexpr std::array<std::string_view, 3> kForces{"N/m", "kN/m", "MN/m"};
  static constexpr std::array<std::string_view, 3> kEnergies{"J/m", "kJ/m", "MJ/m"};
  if (measure == measures::kLength) return kLengths;
  if (measure == measures::kTime) return kTimes;
  if (measure == measures::kStress) return kStresses;
  if (measure == measures::kForce) return kForces;
  return measure == measures::kEnergy ? Names(kEnergies) : Names();
}

}  // namespace

std::string Readable::label(std::string_view name) const {
  return unit.empty() ? std::string(name) : fmt::format("{} [{}]", name, unit);
}

Readable readable(const Described& quantity, double largest) {
  Readable best{1, unit_of(quantity.measure, quantity.units)};
  if (!(largest > 0) || (largest >= kLong && largest < kShort)) return best;
  if (!is_declared(quantity.measure, quantity.units)) return best;
  const auto own = si_factor(quantity.units, dimension_of(quantity.measure));
  bool is_first = true;
  for (const std::string_view name : names_of(quantity.measure)) {
    const auto unit = unit_named(name);
    if (!own || !unit) continue;
    const double factor = *own / unit->factor;
    if (is_first || factor * largest >= 1) best = {factor, std::string(name)};
    is_first = false;
  }
  return best;
}

}  // namespace keyblock::report
