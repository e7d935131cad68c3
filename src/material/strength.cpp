// Checks strengths, and computes the plastic strain over which they change.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/strength.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "material/principal/principal_return.hpp"

namespace keyblock {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

double sine_of(double degrees) {
  return std::sin(degrees * std::numbers::pi / 180);
}

bool has_friction(const Strength& strength) {
  return strength.surface == YieldSurface::mohr_coulomb || strength.surface == YieldSurface::drucker_prager;
}

/// Returns the mean stress at the apex, c cot φ for both surfaces; infinity without friction.
double apex_of(const Strength& strength, const StrengthValues& values) {
  if (!has_friction(strength) || values.friction_deg == 0) return kInfinite;
  return values.cohesion / std::tan(values.friction_deg * std::numbers::pi / 180);
}

// `where`: the object of a case that holds the values.
std::string why_not(const Strength& strength, const StrengthValues& values, const char* where) {
  struct Named {
    const char* name;
    double value;
  };
  for (const Named& n : {Named{"cohesion", values.cohesion}, Named{"yield_stress", values.yield_stress},
                         Named{"tensile_strength", values.tensile_strength.value_or(0)}})
    if (!(n.value >= 0 && std::isfinite(n.value)))
      return fmt::format("expected {} of {}: 0 or more, found {}", n.name, where, n.value);
  for (const Named& n : {Named{"friction_deg", values.friction_deg}, Named{"dilation_deg", values.dilation_deg}})
    if (!(n.value >= 0 && n.value < 90))
      return fmt::format("expected {} of {}: at least 0 and below 90 degrees, found {}", n.name, where, n.value);
  if (strength.surface == YieldSurface::von_mises && values.yield_stress == 0)
    return fmt::format("expected yield_stress of {}: greater than 0, found 0", where);
  if (!has_friction(strength) && (values.friction_deg != 0 || values.dilation_deg != 0))
    return fmt::format("expected no friction_deg and dilation_deg of {} with this surface, found {} and {}", where,
                       values.friction_deg, values.dilation_deg);
  const bool needs_cohesion = strength.surface != YieldSurface::von_mises && values.friction_deg == 0;
  if (needs_cohesion && values.cohesion == 0)
    return fmt::format("expected cohesion of {}: greater than 0 without friction, found 0", where);
  return {};
}

}  // namespace

double compressive_strength(const Strength& strength, const StrengthValues& values) {
  const double sine = sine_of(values.friction_deg);
  switch (strength.surface) {
    case YieldSurface::tresca:
      return 2 * values.cohesion;
    case YieldSurface::von_mises:
      return values.yield_stress;
    case YieldSurface::mohr_coulomb:
      return 2 * values.cohesion * std::sqrt((1 + sine) / (1 - sine));
    case YieldSurface::drucker_prager:
      break;
  }
  // √J2 = s/√3 and I1 = -s under uniaxial compression s.
  const Cone cone = cone_of(strength.matching, values.cohesion, values.friction_deg);
  const double slope = 1 / std::numbers::sqrt3 - cone.slope;
  return slope > 0 ? cone.strength / slope : kInfinite;
}

double strain_of_change(const Strength& strength, double size) {
  if (!strength.change) return kInfinite;
  const StrengthChange& change = *strength.change;
  if (!(change.fracture_energy > 0)) return change.plastic_strain;
  const double fall = compressive_strength(strength, strength.values) - compressive_strength(strength, change.values);
  if (!(fall > 0)) return kInfinite;
  const double sine = sine_of(strength.values.dilation_deg);
  const double flow = (1 + sine) / (1 - sine);
  return 2 * change.fracture_energy / (size * fall) * (flow + 2) / 3;
}

double largest_size(const Strength& strength, double modulus) {
  if (!strength.change || !(strength.change->fracture_energy > 0)) return kInfinite;
  const double fall =
      compressive_strength(strength, strength.values) - compressive_strength(strength, strength.change->values);
  return fall > 0 ? 2 * modulus * strength.change->fracture_energy / (fall * fall) : kInfinite;
}

Strength unreachable_strength() {
  Strength none;
  none.surface = YieldSurface::tresca;
  none.values.cohesion = kInfinite;
  return none;
}

bool is_reachable(const Strength& strength) {
  return std::isfinite(strength.values.cohesion);
}

std::string why_unusable(const Strength& strength) {
  if (std::string why = why_not(strength, strength.values, "strength"); !why.empty()) return why;
  if (!strength.change) return {};
  const StrengthChange& change = *strength.change;
  // Strength may fall to zero.
  StrengthValues last = change.values;
  last.cohesion = last.cohesion == 0 ? strength.values.cohesion : last.cohesion;
  last.yield_stress = last.yield_stress == 0 ? strength.values.yield_stress : last.yield_stress;
  if (std::string why = why_not(strength, last, "after"); !why.empty()) return why;
  const auto is_above = [](double value) { return value > 0 && std::isfinite(value); };
  if (is_above(change.plastic_strain) == is_above(change.fracture_energy))
    return fmt::format("expected one of plastic_strain and fracture_energy of after above 0, found {}",
                       is_above(change.plastic_strain) ? "both" : "neither");
  if (change.values.tensile_strength.has_value() != strength.values.tensile_strength.has_value())
    return "expected a tensile_strength of strength as of after, found one of after alone";
  if (change.fracture_energy > 0 && !(largest_size(strength, 1) < kInfinite))
    return "expected a lower compressive strength by after, which has a fracture_energy, found none";
  return {};
}

std::vector<Finding> doubts_of(const Strength& strength) {
  std::vector<Finding> doubts;
  const auto angles_of = [](const StrengthValues& values) {
    return Facts{{{"dilation_deg", values.dilation_deg}, {"friction_deg", values.friction_deg}}};
  };
  const auto add = [&](const char* code, Facts facts, const char* when) {
    facts.texts.emplace_back("when", when);
    doubts.push_back({code, std::move(facts)});
  };
  const auto look = [&](const StrengthValues& values, const char* when) {
    if (values.dilation_deg > values.friction_deg) add("dilation_above_friction", angles_of(values), when);
  };
  const auto look_at_tension = [&](const StrengthValues& values, const char* when) {
    const double apex = apex_of(strength, values);
    if (values.tensile_strength && *values.tensile_strength > apex)
      add("tensile_strength_without_effect", {{{"tensile_strength", *values.tensile_strength}, {"apex", apex}}}, when);
  };
  look(strength.values, "");
  look_at_tension(strength.values, "");
  const auto angles = [](const StrengthValues& values) { return std::pair(values.friction_deg, values.dilation_deg); };
  if (strength.change && angles(strength.change->values) != angles(strength.values))
    look(strength.change->values, " after the change");
  if (strength.change && strength.change->values.tensile_strength != strength.values.tensile_strength)
    look_at_tension(strength.change->values, " after the change");
  const bool is_cone = strength.surface == YieldSurface::drucker_prager;
  if (!is_cone && strength.matching != ConeMatching::compression) doubts.push_back({"matching_without_effect"});
  if (is_cone && strength.matching == ConeMatching::plane_strain &&
      strength.values.dilation_deg != strength.values.friction_deg)
    doubts.push_back({"matching_without_associated_flow", angles_of(strength.values)});
  if (strength.change && strength.change->plastic_strain > 0 &&
      compressive_strength(strength, strength.change->values) < compressive_strength(strength, strength.values))
    doubts.push_back({"softening_without_fracture_energy"});
  return doubts;
}

}  // namespace keyblock
