// Composes names of units from those that a case declares.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/units/measure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "problem/units/unit_names.hpp"

namespace keyblock {
namespace {

/// Names of the base units, and the sign between them.
struct Words {
  std::string mass;
  std::string length;
  std::string time;
  std::string force;   ///< empty: composed from base units
  std::string stress;  ///< empty: force over length²
  std::string_view times;
};

// Returns the name that is as large as the unit made of the base units.
template <std::size_t N>
std::string named(const Units& units, const Dimension& dimension, const std::array<std::string_view, N>& names) {
  const std::optional<double> factor = si_factor(units, dimension);
  if (!factor) return {};
  for (const std::string_view name : names)
    if (const std::optional<Unit> unit = unit_named(name); unit && std::abs(*factor / unit->factor - 1) < kSameUnit)
      return std::string(name);
  return {};
}

std::string power_of(const std::string& name, double power) {
  if (power == 1) return name;
  if (power == 2) return name + "²";
  if (power == 3) return name + "³";
  if (power == 0.5) return "√" + name;
  return fmt::format("{}^{:g}", name, power);
}

/// Product of powers; negative ones follow a stroke.
class Product {
 public:
  explicit Product(std::string_view times) : times_(times) {}

  void take(const std::string& name, double power) {
    if (power > 0) {
      const std::string factor = power_of(name, power);
      above_ += (above_.empty() ? "" : std::string(times_)) + factor;
    }
    if (power < 0) below_.append("/").append(power_of(name, -power));
  }
  std::string text() const { return (above_.empty() ? "1" : above_) + below_; }

 private:
  std::string_view times_;
  std::string above_;
  std::string below_;
};

void take_bases(Product& product, const Words& words, const Dimension& left) {
  product.take(words.mass, left.mass);
  product.take(words.length, left.length);
  product.take(words.time, left.time);
}

// Force replaces mass that is accelerated or moved: N, N·m, N·s.
std::string spelt(const Dimension& dimension, const Words& words) {
  Product product(words.times);
  if (dimension == kStress && !words.stress.empty()) return words.stress;
  const bool has_force = !words.force.empty() && (dimension.time <= -1 || words.mass.empty());
  if (dimension.mass != 1 || !has_force) {
    take_bases(product, words, dimension);
    return product.text();
  }
  product.take(words.force, 1);
  take_bases(product, words, {0, dimension.length - kForceDimension.length, dimension.time - kForceDimension.time});
  return product.text();
}

bool is_said(const Dimension& dimension, const Units& units) {
  return si_factor(units, dimension).has_value();
}

Words words_of(const Units& units) {
  // A product is not a name: mass is then written by force, or by stress if force has no name either.
  const bool has_name = units.mass.find("·") == std::string::npos;
  Words words{
      has_name ? units.mass : std::string(), units.length, units.time, named(units, kForceDimension, kForceUnits),
      named(units, kStress, kStressUnits),   "·"};
  if (!has_name && words.force.empty() && !words.stress.empty()) words.force = words.stress + "·" + units.length + "²";
  return words;
}

const Words kLetters{"M", "L", "T", "F", "", " "};

}  // namespace

Dimension dimension_of(const Measure& measure) {
  Dimension dimension = measure.dimension;
  if (measure.of_slice) dimension.length -= 1;
  return dimension;
}

bool is_declared(const Measure& measure, const Units& units) {
  if (measure.dimension == Dimension{}) return !measure.angle.empty();
  return is_said(measure.dimension, units) && (!measure.of_slice || !units.length.empty());
}

std::string unit_of(const Measure& measure, const Units& units) {
  if (measure.dimension == Dimension{}) return std::string(measure.angle);
  const bool is_known = is_declared(measure, units);
  std::string text = spelt(measure.dimension, is_known ? words_of(units) : kLetters);
  if (!measure.angle.empty() && text.starts_with("1/"))
    text = fmt::format("{}{}", measure.angle, std::string_view(text).substr(1));
  return is_known && measure.of_slice ? text + "/" + units.length : text;
}

std::string with_unit(std::string_view name, const Measure& measure, const Units& units) {
  const std::string unit = unit_of(measure, units);
  return unit.empty() ? std::string(name) : fmt::format("{} [{}]", name, unit);
}

std::string with_declared(std::string_view name, const Measure& measure, const Units& units) {
  return is_declared(measure, units) ? with_unit(name, measure, units) : std::string(name);
}

namespace {

struct Example {
  Measure measure;
  std::string_view noun;
  std::string_view value;
};
constexpr auto kExamples = std::to_array<Example>({
    {measures::kLength, "a length", "2.5 m"},
    {measures::kArea, "an area", "2 m2"},
    {measures::kTime, "a time", "2 ms"},
    {measures::kVelocity, "a velocity", "1.5 m/s"},
    {measures::kAcceleration, "an acceleration", "9.81 m/s2"},
    {measures::kRotationRate, "a rate of rotation", "0.1 rad/s"},
    {measures::kRate, "a rate", "2 1/s"},
    {measures::kStress, "a stress", "20 GPa"},
    {measures::kDensity, "a mass per volume", "2600 kg/m3"},
    {measures::kForcePerVolume, "a weight per volume", "26 kN/m3"},
    {measures::kToughness, "a stress intensity", "1.5 MPa√m"},
    {measures::kEnergyPerArea, "an energy per area", "80 J/m2"},
    {measures::kMass, "a mass per length of thickness", "2 t/m"},
    {measures::kMomentOfInertia, "a moment of inertia per length of thickness", "3 t·m2/m"},
    {measures::kForce, "a force per length of thickness", "50 kN/m"},
    {measures::kMoment, "a moment per length of thickness", "5 kN·m/m"},
    {measures::kStiffness, "a stiffness per length of thickness", "20 MN/m/m"},
    {measures::kMomentum, "a momentum per length of thickness", "5 kN·s/m"},
    {measures::kAngularMomentum, "an angular momentum per length of thickness", "5 kN·m·s/m"},
    {measures::kRadians, "an angle", "0.5 rad"},
    {measures::kDegrees, "an angle", "30 deg"},
});

const Example& example(const Measure& measure) {
  const auto found = std::ranges::find(kExamples, measure, &Example::measure);
  return found == kExamples.end() ? kExamples.back() : *found;
}

}  // namespace

std::string_view example_value(const Measure& measure) {
  return example(measure).value;
}

std::string example_of(const Measure& measure) {
  const auto& [of, noun, value] = example(measure);
  return fmt::format("{}, such as \"{}\"", noun, value);
}

Converted converted(std::string_view text, const Measure& measure, const Units& units) {
  const std::optional<Quantity> quantity = quantity_in(text);
  const std::optional<Unit> unit = quantity ? unit_named(quantity->unit) : std::nullopt;
  if (!unit) return {};
  const bool is_angle = measure.dimension == Dimension{} && !measure.angle.empty();
  if (unit->is_angle != is_angle || (!is_angle && unit->dimension != dimension_of(measure))) return {};
  if (is_angle) {
    const double degrees = quantity->number * unit->factor;
    return {measure.angle == "rad" ? degrees * kDegree : degrees};
  }
  const std::optional<double> factor = si_factor(units, dimension_of(measure));
  if (!factor) return {std::nullopt, true};
  return {quantity->number * unit->factor / *factor};
}

}  // namespace keyblock
