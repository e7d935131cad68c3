// The table of units, and products and powers of them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/units/unit_conversion.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>

namespace keyblock {
namespace {

struct NamedUnit {
  std::string_view name;
  Dimension dimension;
  double factor;
  bool takes_prefix;
};

constexpr double kPound = 0.45359237;         // kg, exact
constexpr double kFoot = 0.3048;              // m, exact
constexpr double kStandardGravity = 9.80665;  // m/s2, exact
constexpr double kPoundForce = kPound * kStandardGravity;
constexpr Dimension kMass{1, 0, 0};
constexpr Dimension kForce{1, 1, -2};

constexpr std::array<NamedUnit, 29> kUnits{{
    {"m", {0, 1, 0}, 1, true},
    {"in", {0, 1, 0}, kFoot / 12, false},
    {"ft", {0, 1, 0}, kFoot, false},
    {"yd", {0, 1, 0}, 3 * kFoot, false},
    {"g", kMass, 1e-3, true},
    {"t", kMass, 1e3, true},
    {"tonne", kMass, 1e3, false},
    {"lb", kMass, kPound, false},
    {"slug", kMass, kPoundForce / kFoot, false},
    {"s", {0, 0, 1}, 1, true},
    {"min", {0, 0, 1}, 60, false},
    {"h", {0, 0, 1}, 3600, false},
    {"d", {0, 0, 1}, 86400, false},
    {"day", {0, 0, 1}, 86400, false},
    {"year", {0, 0, 1}, 365.25 * 86400, false},
    {"N", kForce, 1, true},
    {"lbf", kForce, kPoundForce, false},
    {"kip", kForce, 1e3 * kPoundForce, false},
    {"Pa", kStress, 1, true},
    {"bar", kStress, 1e5, true},
    {"psi", kStress, kPoundForce / (kFoot * kFoot / 144), false},
    {"ksi", kStress, 1e3 * kPoundForce / (kFoot * kFoot / 144), false},
    {"psf", kStress, kPoundForce / (kFoot * kFoot), false},
    {"pcf", kForcePerVolume, kPoundForce / (kFoot * kFoot * kFoot), false},
    {"J", {1, 2, -2}, 1, true},
    {"Hz", {0, 0, -1}, 1, true},
    {"gn", kAcceleration, kStandardGravity, false},
    {"kgf", kForce, kStandardGravity, false},
    {"tf", kForce, 1e3 * kStandardGravity, false},
}};

struct Prefix {
  std::string_view name;
  double factor;
};
constexpr std::array<Prefix, 9> kPrefixes{
    {{"k", 1e3}, {"M", 1e6}, {"G", 1e9}, {"m", 1e-3}, {"c", 1e-2}, {"d", 1e-1}, {"u", 1e-6}, {"µ", 1e-6}, {"h", 1e2}}};

const NamedUnit* find_unit(std::string_view name) {
  const auto found = std::ranges::find(kUnits, name, &NamedUnit::name);
  return found == kUnits.end() ? nullptr : &*found;
}

std::optional<Unit> simple_unit(std::string_view name) {
  if (name == "deg" || name == "°") return Unit{{}, 1, true};
  if (name == "rad") return Unit{{}, 180 / std::numbers::pi, true};
  if (const NamedUnit* unit = find_unit(name)) return Unit{unit->dimension, unit->factor, false};
  for (const Prefix& prefix : kPrefixes) {
    if (!name.starts_with(prefix.name)) continue;
    const NamedUnit* unit = find_unit(name.substr(prefix.name.size()));
    if (unit != nullptr && unit->takes_prefix) return Unit{unit->dimension, prefix.factor * unit->factor, false};
  }
  return std::nullopt;
}

// The power behind a name: "m3", "m^3", "m³", "s-2" have one.
int take_power(std::string_view& name) {
  constexpr std::array<std::pair<std::string_view, int>, 6> kPowers{
      {{"^2", 2}, {"^3", 3}, {"²", 2}, {"³", 3}, {"2", 2}, {"3", 3}}};
  for (const auto& [text, power] : kPowers) {
    if (!name.ends_with(text)) continue;
    name.remove_suffix(text.size());
    return power;
  }
  return 1;
}

}  // namespace

std::optional<Unit> unit_named(std::string_view name) {
  Unit product;
  int sign = 1;
  while (true) {
    const std::size_t end = name.find_first_of("/*");
    std::string_view part = name.substr(0, end);
    const int power = sign * take_power(part);
    const std::optional<Unit> unit = simple_unit(part);
    if (!unit || (unit->is_angle && (end != std::string_view::npos || sign < 0 || power != 1))) return std::nullopt;
    if (unit->is_angle) return unit;
    product.dimension.mass += power * unit->dimension.mass;
    product.dimension.length += power * unit->dimension.length;
    product.dimension.time += power * unit->dimension.time;
    product.factor *= std::pow(unit->factor, power);
    if (end == std::string_view::npos) return product;
    sign = name[end] == '/' ? -1 : 1;
    name.remove_prefix(end + 1);
  }
}

std::optional<Quantity> quantity_in(std::string_view text) {
  Quantity found;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), found.number);
  if (error != std::errc{} || !std::isfinite(found.number)) return std::nullopt;
  std::string_view rest(end, static_cast<std::size_t>(text.data() + text.size() - end));
  while (rest.starts_with(' ')) rest.remove_prefix(1);
  while (rest.ends_with(' ')) rest.remove_suffix(1);
  if (rest.empty() || rest.find(' ') != std::string_view::npos) return std::nullopt;
  found.unit = rest;
  return found;
}

std::optional<double> si_factor(const Units& units, const Dimension& dimension) {
  double factor = 1;
  const auto take = [&](const std::string& name, int power) {
    if (power == 0) return true;
    const std::optional<Unit> unit = unit_named(name);
    if (!unit) return false;
    factor *= std::pow(unit->factor, power);
    return true;
  };
  if (!take(units.mass, dimension.mass) || !take(units.length, dimension.length) || !take(units.time, dimension.time))
    return std::nullopt;
  return factor;
}

std::string example_of(const Dimension& dimension) {
  if (dimension == kLengthDimension) return "a length, such as \"2.5 m\"";
  if (dimension == kTimeDimension) return "a time, such as \"2 ms\"";
  if (dimension == kAcceleration) return "an acceleration, such as \"9.81 m/s2\"";
  if (dimension == kStress) return "a stress, such as \"20 GPa\"";
  if (dimension == kDensity) return "a mass per volume, such as \"2600 kg/m3\"";
  if (dimension == kForcePerVolume) return "a weight per volume, such as \"26 kN/m3\"";
  if (dimension == kForcePerLength) return "a force per length of thickness, such as \"50 kN/m\"";
  return "an angle, such as \"30 deg\"";
}

}  // namespace keyblock
