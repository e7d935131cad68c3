// Compares numbers of the input with those of rock, soil and masonry on the earth, in SI.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/ahead/plausible_units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "base/sentences/sentences.hpp"
#include "base/words/plain_number.hpp"
#include "geometry/box.hpp"
#include "material/strength.hpp"
#include "problem/units/unit_conversion.hpp"

namespace keyblock {
namespace {

constexpr double kLeastStrength = 1e-7;  // of the modulus

/// Plausible range of a quantity for rock, soil and masonry on the earth, in SI.
struct Plausible {
  const char* what;
  Dimension dimension;
  double least;
  double most;
  const char* unit;
};
constexpr Plausible kGravity{"gravity", kAcceleration, 0.01, 1000, "m/s2"};
constexpr Plausible kModulus{"youngs_modulus", kStress, 1e4, 1e12, "Pa"};
constexpr Plausible kMassDensity{"density", kDensity, 100, 25000, "kg/m3"};  // snow to gold
constexpr double kLeastUnitWeight = 15;                                      // kN/m3, of soil and rock
constexpr double kMostUnitWeight = 35;
constexpr double kSmallestScene = 0.03;  // m: a slope drawn in metres and read as millimetres is smaller
constexpr double kLargestScene = 5000;   // m

Finding implausible(const char* form, const Plausible& bounds, double value, const Units& units) {
  const std::optional<double> factor = si_factor(units, bounds.dimension);
  const double si = factor ? std::abs(value) * *factor : 0;
  if (value == 0 || !factor || (si >= bounds.least && si <= bounds.most)) return {};
  return {form,
          {{{"value", value}, {"si", si}, {"least", bounds.least}, {"most", bounds.most}},
           {{"what", bounds.what},
            {"unit", bounds.unit},
            {"units", units.length + (units.mass.empty() ? "" : ", " + units.mass) +
                          (units.time.empty() ? "" : ", " + units.time)}}}};
}

/// Explains why a gravity is that of the earth in another unit than declared; empty if it is not.
Finding gravity_of_another_unit(double gravity, const Units& units) {
  // 981 cm/s2 is left out: in metres it is a centrifuge of 100 g.
  constexpr std::array<std::pair<double, const char*>, 3> kEarth{{{9.81, "m/s2"}, {32.17, "ft/s2"}, {386.1, "in/s2"}}};
  constexpr double kSame = 0.01;  // fraction: 9.8 to 9.9, 32 to 32.2
  const std::optional<double> factor = si_factor(units, kAcceleration);
  if (!factor || std::abs(gravity * *factor - kEarth[0].first) <= 2 * kSame * kEarth[0].first) return {};
  for (const auto& [value, unit] : kEarth)
    if (std::abs(gravity - value) <= kSame * value)
      return {"implausible_gravity:of_another_unit",
              {{{"value", gravity}, {"si", gravity * *factor}, {"of_earth", kEarth[0].first / *factor}},
               {{"unit", unit}, {"units", units.length + ", " + units.time}}}};
  return {};
}

/// Explains why a friction angle cannot be in degrees; empty if it can.
Finding in_radians(double degrees) {
  if (!(degrees > 0 && degrees < std::numbers::pi / 2)) return {};
  return {"angle_in_radians", {{{"angle", degrees}, {"meant", degrees / kDegree}}}};
}

/// Does the same for a dilation angle. Small ones are plausible in degrees. The test requires less than 1, next to
/// friction in degrees; in radians that is less than 57 degrees.
Finding dilation_in_radians(const StrengthValues& values) {
  if (!(values.dilation_deg > 0 && values.dilation_deg < 1 && values.friction_deg > 10)) return {};
  return {
      "angle_in_radians:of_dilation",
      {{{"angle", values.dilation_deg}, {"friction", values.friction_deg}, {"meant", values.dilation_deg / kDegree}}}};
}

/// Does the same for all angles of a strength: rock softens to little friction, but not to a degree.
Finding in_radians(const Strength& strength) {
  std::vector<StrengthValues> all{strength.values};
  if (strength.change) all.push_back(strength.change->values);
  for (const StrengthValues& values : all) {
    if (Finding why = in_radians(values.friction_deg); !why.empty()) return why;
    if (Finding why = dilation_in_radians(values); !why.empty()) return why;
  }
  return {};
}

/// Explains why strength and modulus cannot have one unit; empty if they can. Rock and soil have a strength of 1e-2 to
/// 1e-4 of the modulus, weightless benchmarks 1e-6.
Finding beside_modulus(const BlockMaterial& material) {
  const double strength = compressive_strength(*material.strength, material.strength->values);
  if (strength > 0 && strength < kLeastStrength * material.youngs_modulus)
    return {"implausible_strength:weak",
            {{{"strength", strength},
              {"ratio", strength / material.youngs_modulus},
              {"youngs_modulus", material.youngs_modulus}}}};
  if (!(strength > material.youngs_modulus)) return {};
  return {"implausible_strength:above_modulus",
          {{{"strength", strength}, {"youngs_modulus", material.youngs_modulus}}}};
}

Box box_about(const Model& model) {
  Box box;
  for (const Point p : model.start_vertices) box.add(p);
  return box;
}

/// Explains why the drawing cannot be in the declared unit; empty if it can.
Finding implausible_size(const Model& model, const Units& units) {
  const std::optional<double> metres = si_factor(units, kLengthDimension);
  if (!metres || model.start_vertices.empty()) return {};
  const Point size = box_about(model).size();
  const double greatest = std::max(size.x, size.y) * *metres;
  if (greatest >= kSmallestScene && greatest <= kLargestScene) return {};
  return {"implausible_size",
          {{{"width", size.x}, {"height", size.y}, {"least", kSmallestScene}, {"most", kLargestScene}},
           {{"unit", units.length}}}};
}

/// Explains why a density is a unit weight; empty if it is not.
Finding density_in_kilonewton(double density, const Units& units) {
  const std::optional<double> factor = si_factor(units, kDensity);
  const double si = factor ? density * *factor : 0;
  if (!(si >= kLeastUnitWeight && si <= kMostUnitWeight)) return {};
  return {"implausible_density:unit_weight", {{{"value", density}, {"si", si}, {"of_rock", si * 1000 / 9.81}}}};
}

}  // namespace

Warnings contradictions_of(const BlockMaterial& material, const Units& units) {
  Warnings found;
  const auto put = [&](Finding finding) {
    if (!finding.empty()) found.push_back(warning_of(std::move(finding), material.place));
  };
  put(implausible("implausible_modulus", kModulus, material.youngs_modulus, units));
  Finding as_weight = density_in_kilonewton(material.density, units);
  put(as_weight.empty() ? implausible("implausible_density", kMassDensity, material.density, units)
                        : std::move(as_weight));
  if (!material.strength) return found;
  put(beside_modulus(material));
  put(in_radians(*material.strength));
  return found;
}

Warnings implausible_units(const Problem& problem, const Settings& settings, const Model& model) {
  Warnings found;
  const auto put = [&](Finding finding, const Place& place) {
    if (!finding.empty()) found.push_back(warning_of(std::move(finding), place));
  };
  const double gravity = length(settings.gravity);
  Finding unlikely = implausible("implausible_gravity", kGravity, gravity, problem.units);
  put(unlikely.empty() ? gravity_of_another_unit(gravity, problem.units) : std::move(unlikely),
      problem.analysis->place);
  const auto* drawing = std::get_if<Drawing>(&problem.geometry);
  put(implausible_size(model, problem.units), drawing != nullptr ? drawing->place : problem.analysis->place);
  for (const BlockMaterial& material : problem.analysis->block_materials)
    found = joined(std::move(found), contradictions_of(material, problem.units));
  if (settings.gravity.y > 0)
    put({"gravity_points_upward", {{{"gravity", settings.gravity.y}}}}, problem.analysis->place);
  for (const JointMaterial& joint : problem.analysis->joint_materials)
    put(in_radians(joint.friction_angle_deg), joint.place);
  return found;
}

std::string size_of_scene(const Model& model, const Units& units) {
  if (model.start_vertices.empty()) return {};
  const Box box = box_about(model);
  const std::string unit = units.length.empty() ? "" : " " + units.length;
  return fmt::format("{}{} by {}{}{}", plain(box.size().x), unit, plain(box.size().y), unit,
                     unit.empty() ? " (no unit declared)" : "");
}

}  // namespace keyblock
