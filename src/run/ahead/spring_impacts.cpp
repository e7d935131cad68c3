// Tests the lightest free body, which oscillates fastest on the springs, for all bodies.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/ahead/spring_impacts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

#include "base/sentences/sentences.hpp"
#include "geometry/simplex.hpp"
#include "model/shared_covers.hpp"
#include "model/state.hpp"
#include "step/bodies/integrator.hpp"

namespace keyblock {
namespace {

// ω dt above which a step exceeds a sixth of the period of a block on its springs: the blow lasts less than four steps.
constexpr double kUnresolved = 1;
// Steps within a blow that resolve it, as the setting `impact` requires.
constexpr double kStepsOfBlow = 20;
// Limits of the integration of a blow. A larger ratio of stiffnesses, or more damping, changes nothing. Step and end
// are relative to the fastest and the slowest frequency.
constexpr double kFarApart = 1e3;
constexpr double kOverdamped = 10;
constexpr double kOfPeriod = 0.02;
constexpr double kPeriods = 40;
// Rebound above which no warning is given.
constexpr double kNearlyAll = 0.95;

/// Block, or all elements of an NMM body.
struct Striker {
  int element = -1;  ///< its first, index from 0
  double mass = std::numeric_limits<double>::max();
};

std::set<int> held_elements(const Model& model) {
  std::set<int> held;
  for (const CarriedPoint& point : model.fixed_points) held.insert(point.element.value);
  return held;
}

std::optional<Striker> lightest(const Model& model, const Settings& settings) {
  const std::vector<int> bodies = body_numbers(model);
  const std::set<int> held = held_elements(model);
  std::vector<Striker> all(model.elements.size());
  Table<VertexIndex, Point> places;
  for (const Point& vertex : model.start_vertices) places.push_back(vertex);
  for (const ElementIndex e : indices(model.elements)) {
    Striker& striker = all[static_cast<std::size_t>(bodies[static_cast<std::size_t>(e.value)])];
    if (striker.element < 0) striker = {e.value, 0};
    striker.mass += model.material_of(model.elements[e]).density * place(model, places, e, settings).moments.area;
  }
  const auto is_free = [&](const Striker& s) {
    return s.element >= 0 && !held.contains(s.element) && model.elements[ElementIndex{s.element}].can_move();
  };
  std::optional<Striker> found;
  for (const Striker& striker : all)
    if (is_free(striker) && (!found || striker.mass < found->mass)) found = striker;
  return found;
}

// Models a square of unit thickness. Strain stiffness between corners and centroid is 4 E'. Critical damping is 2/ω of
// its slowest strain mode, simple shear.
SpringImpact impact_of(const Model& model, const Settings& settings, const Striker& striker) {
  const Element& element = model.elements[ElementIndex{striker.element}];
  const BlockMaterial& material = model.material_of(element);
  const double nu = material.poissons_ratio;
  const double modulus = material.youngs_modulus / (settings.plane == Plane::strain ? 1 - nu * nu : 1);
  SpringImpact impact{striker.mass, 2 * settings.contact_penalty, 4 * modulus, 0};
  if (element.is_on_covers() || element.basis->unknown_count() <= 3) return impact;
  const double shear = std::sqrt(12 * material.youngs_modulus / (1 + nu) / striker.mass);
  const bool is_critical = settings.standard.strain_damping == StrainDamping::critical;
  const double by_rule =
      is_critical ? std::max(0.0, 2 / shear - damping_of_rule(settings.standard, settings.time_step)) : 0;
  impact.damping_time = settings.stiffness_damping.of(element.material).value_or(by_rule);
  return impact;
}

Facts facts_of(const Model& model, const Striker& striker) {
  const ElementIndex e{striker.element};
  return {{}, {{"body", model.elements[e].is_on_covers() ? "the body of element" : "block"}}, {model.number_of(e)}};
}

Finding unresolved(const Settings& settings, const SpringImpact& impact, double frequency, Facts facts) {
  const double resolved = std::numbers::pi / (kStepsOfBlow * frequency);
  facts.numbers = {{"time_step", settings.time_step},
                   {"mass", impact.mass},
                   {"stiffness", impact.stiffness},
                   {"ratio", frequency * settings.time_step},
                   {"limit", kUnresolved},
                   {"resolved_step", resolved},
                   {"resolved_penalty", settings.contact_penalty * std::pow(resolved / settings.time_step, 2)}};
  return {"springs_unresolved", std::move(facts)};
}

}  // namespace

// The corners may strike several times. The block has left once it is farther away than its strain oscillates.
double SpringImpact::rebound() const {
  const double springs = std::min(stiffness, kFarApart * strain_stiffness);
  const double strain = std::min(strain_stiffness, kFarApart * stiffness);
  const double corner = mass / 3;  // inertia of the strain that moves the corners
  const double fastest = std::sqrt((springs + strain) / corner);
  const double damping = std::min(damping_time * strain / corner, kOverdamped * fastest);
  const double dt = kOfPeriod / std::max(fastest, damping);
  const double away = 2 * std::sqrt(mass / strain);
  const double longest = kPeriods / std::sqrt(std::min(springs, strain) / mass);
  double y = 0, s = 0, v = -1, rate = 0;  // centroid, and corners relative to it
  for (double t = 0; t < longest && y < away; t += dt) {
    const double force = -springs * std::min(0.0, y + s);
    v += dt * force / mass;
    rate += dt * ((force - strain * s) / corner - damping * rate);
    y += dt * v;
    s += dt * rate;
  }
  return std::max(0.0, v);
}

Warnings spring_impacts(const Scene& scene, const Place& place) {
  const Settings& settings = scene.settings;
  const Model& model = scene.model;
  const bool springs_stop = settings.dynamics == Dynamics::standard &&
                            settings.standard.motion == MotionRule::dynamic &&
                            settings.standard.impact == ImpactLaw::springs;
  const std::optional<Striker> striker = springs_stop ? lightest(model, settings) : std::nullopt;
  if (!striker) return {};
  Warnings found;
  const SpringImpact impact = impact_of(model, settings, *striker);
  const double frequency = std::sqrt(impact.stiffness / impact.mass);
  if (frequency * settings.time_step > kUnresolved && settings.step_control == StepControl::constant)
    found.push_back(warning_of(unresolved(settings, impact, frequency, facts_of(model, *striker)), place));
  if (!(impact.damping_time > 0)) return found;
  SpringImpact undamped = impact;
  undamped.damping_time = 0;
  const double rebound = impact.rebound();
  if (rebound >= kNearlyAll * undamped.rebound()) return found;
  const bool is_given =
      settings.stiffness_damping.of(model.elements[ElementIndex{striker->element}].material).has_value();
  Facts facts = facts_of(model, *striker);
  facts.numbers = {{"height", rebound * rebound}, {"undamped_height", undamped.rebound() * undamped.rebound()}};
  facts.texts.emplace_back("damping", is_given ? "stiffness_damping" : "strain_damping=critical");
  facts.texts.emplace_back("remedy", is_given ? "stiffness_damping=0" : "strain_damping=none");
  found.push_back(warning_of({"strain_damping_takes_rebound", std::move(facts)}, place));
  return found;
}

}  // namespace keyblock
