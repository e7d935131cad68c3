// Holds the table of units, and computes products and powers of them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/units/unit_conversion.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <vector>

#include "problem/units/unit_names.hpp"

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
    {"N", kForceDimension, 1, true},
    {"lbf", kForceDimension, kPoundForce, false},
    {"kip", kForceDimension, 1e3 * kPoundForce, false},
    {"Pa", kStress, 1, true},
    {"bar", kStress, 1e5, true},
    {"psi", kStress, kPoundForce / (kFoot * kFoot / 144), false},
    {"ksi", kStress, 1e3 * kPoundForce / (kFoot * kFoot / 144), false},
    {"psf", kStress, kPoundForce / (kFoot * kFoot), false},
    {"pcf", kForcePerVolume, kPoundForce / (kFoot * kFoot * kFoot), false},
    {"J", {1, 2, -2}, 1, true},
    {"Hz", {0, 0, -1}, 1, true},
    {"gn", kAcceleration, kStandardGravity, false},
    {"kgf", kForceDimension, kStandardGravity, false},
    {"tf", kForceDimension, 1e3 * kStandardGravity, false},
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

// Removes the power from a name and returns it: "m3", "m^3", "m³", "s^-1", "m^1.5" have one.
std::optional<double> take_power(std::string_view& name) {
  if (const std::size_t hat = name.find('^'); hat != std::string_view::npos) {
    const std::string_view power = name.substr(hat + 1);
    double value = 0;
    const auto [end, error] = std::from_chars(power.data(), power.data() + power.size(), value);
    if (error != std::errc{} || end != power.data() + power.size() || !std::isfinite(value)) return std::nullopt;
    name = name.substr(0, hat);
    return value;
  }
  constexpr std::array<std::pair<std::string_view, double>, 4> kPowers{{{"²", 2}, {"³", 3}, {"2", 2}, {"3", 3}}};
  for (const auto& [text, power] : kPowers) {
    if (!name.ends_with(text)) continue;
    name.remove_suffix(text.size());
    return power;
  }
  return 1;
}

/// Factor of a product.
struct Part {
  std::string_view name;
  bool is_over = false;  ///< follows a stroke
  bool is_root = false;
};

// Splits "kN·m/s" into kN, m and s; "MPa√m" into MPa and the root of m.
std::vector<Part> parts_of(std::string_view name) {
  constexpr std::array<std::string_view, 4> kSigns{"/", "*", "·", "√"};
  std::vector<Part> parts{{}};
  std::size_t begin = 0;
  for (std::size_t at = 0; at < name.size();) {
    const std::string_view rest = name.substr(at);
    const auto sign = std::ranges::find_if(kSigns, [&](std::string_view s) { return rest.starts_with(s); });
    if (sign == kSigns.end()) {
      ++at;
      continue;
    }
    const bool is_root = *sign == kSigns[3];
    // A root may open the name, or follow another sign directly.
    if (is_root && at == begin) {
      parts.back().is_root = true;
    } else {
      parts.back().name = name.substr(begin, at - begin);
      parts.push_back({{}, *sign == kSigns[0], is_root});
    }
    at += sign->size();
    begin = at;
  }
  parts.back().name = name.substr(begin);
  return parts;
}

// Returns false if the part is no unit, or none allowed there.
bool multiply(Unit& product, Part part, bool is_first) {
  if (part.name == "1" && is_first && !part.is_root) return true;
  const std::optional<double> written = take_power(part.name);
  if (!written) return false;
  const double power = *written * (part.is_over ? -1 : 1) * (part.is_root ? 0.5 : 1);
  const std::optional<Unit> unit = simple_unit(part.name);
  if (!unit || (unit->is_angle && (!is_first || power != 1))) return false;
  product.dimension.mass += power * unit->dimension.mass;
  product.dimension.length += power * unit->dimension.length;
  product.dimension.time += power * unit->dimension.time;
  product.factor *= std::pow(unit->is_angle ? unit->factor * kDegree : unit->factor, power);
  return true;
}

// Returns the name of a unit of mass of equal size, or the composed name.
std::string known_mass(const std::string& made) {
  const std::optional<Unit> unit = unit_named(made);
  if (!unit || unit->dimension != kMass) return {};
  for (const std::string_view name : kMassUnits)
    if (std::abs(unit->factor / unit_named(name)->factor - 1) < kSameUnit) return std::string(name);
  return made;
}

}  // namespace

std::optional<Unit> unit_named(std::string_view name) {
  const std::vector<Part> parts = parts_of(name);
  if (parts.size() == 1 && !parts[0].is_root)
    if (const std::optional<Unit> unit = simple_unit(name); unit && unit->is_angle) return unit;
  Unit product;
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (!multiply(product, parts[i], i == 0)) return std::nullopt;
  const bool is_number = product.dimension == Dimension{};  // "1", "rad/1", "m/m"
  if (is_number && parts.size() == 1) return std::nullopt;
  return product;
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

std::string mass_of_force(const std::string& force, const std::string& length, const std::string& time) {
  return known_mass(force + "·" + time + "²/" + length);
}

std::string mass_of_stress(const std::string& stress, const std::string& length, const std::string& time) {
  return known_mass(stress + "·" + length + "·" + time + "²");
}

std::optional<double> si_factor(const Units& units, const Dimension& dimension) {
  double factor = 1;
  const auto take = [&](const std::optional<double>& unit, double power) {
    if (power == 0) return true;
    if (unit) factor *= std::pow(*unit, power);
    return unit.has_value();
  };
  const auto named = [](const std::string& name) {
    const std::optional<Unit> unit = unit_named(name);
    return unit ? std::optional(unit->factor) : std::nullopt;
  };
  if (!take(named(units.mass), dimension.mass) || !take(named(units.length), dimension.length) ||
      !take(named(units.time), dimension.time))
    return std::nullopt;
  return factor;
}

}  // namespace keyblock
