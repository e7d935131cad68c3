// Selects the contacts whose velocity must stop, and the friction of their impulses; see clean_up.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/time/clean_up.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "contact/find/connected_sets.hpp"
#include "contact/rows/gap.hpp"
#include "step/bodies/unresolved_strain.hpp"
#include "step/newton/tolerances.hpp"
#include "step/time/ledger.hpp"

namespace keyblock {
namespace {

using namespace tolerances;

// Work of a contact force over twice the overlap that stopped strain rates would make in the next step. The unit is the
// largest load, or what stops the largest momentum in a step, times the size of blocks. Slivers, which strain fast,
// stay below it; more would cost time.
constexpr double kWorkOfOverlap = 3e-6;

class CleanUp {
 public:
  explicit CleanUp(const ClosingStep& of) : of_(of), before_(of.smooth.v) {
    if (stops_strain()) stop_unresolved(of_.scene.bodies(), of_.whole, before_);
    const std::vector<Part> parts = parts_of_contacts();
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (parts[i] == Part::none) continue;
      held_.push_back(i);
      touches_.push_back(of_.touches[i]);
      slips_.push_back(parts[i] == Part::stops ? slip_held(i) : HeldSlip{.passes_on = passed_on_by(i)});
    }
  }

  CleanedVelocities run() const {
    const double per_force = of_.rule.end_velocity.increment;
    PushedVelocities pushed = stops_strain() && of_.dt < of_.whole ? pushed_by({flexibility_of_part(), per_force})
                                                                   : pushed_by({of_.smooth.flexibility, per_force});
    const bool has_inertia_of_step =
        std::ranges::any_of(touches_, [&](const Touch& touch) { return resolves_impact(of_.scene, touch); });
    if (!has_inertia_of_step) return {std::move(pushed.v), pushed.given};
    pushed = without_gain(std::move(pushed));
    // Pushes that the mass answers give rates to strains, of which the next step would make strains.
    if (stops_strain()) stop_unresolved(of_.scene.bodies(), of_.whole, pushed.v);
    const double given_up = kinetic_energy(of_.scene, before_) - kinetic_energy(of_.scene, pushed.v);
    return {std::move(pushed.v), pushed.given, std::max(0.0, given_up)};
  }

 private:
  // Only where the elastic force follows the strain rate (3.6).
  bool stops_strain() const { return of_.rule.strain.velocity != 0; }
  bool has_stopped_strain(const Touch& touch) const {
    const auto stops = [&](VertexIndex v) {
      return is_unresolved(of_.scene.bodies()[of_.scene.model.vertices[v].element], of_.whole);
    };
    return stops_strain() && (stops(touch.vertex) || stops(touch.start));
  }

  double normal(std::size_t i) const { return of_.smooth.forces[static_cast<Eigen::Index>(2 * i)]; }
  bool has_spring(std::size_t i) const { return of_.smooth.laws[i].normal_compliance > 0; }
  bool was_open(std::size_t i) const { return !of_.start.closed.of(of_.touches[i]); }

  // Part of a contact in the clean-up: its normal velocity stops, or it passes on impulses and must not close faster.
  enum class Part { none, passes_on, stops };

  // Contacts with multipliers stop, and springs that would rebound after closing. Such springs belong to NMM bodies,
  // with all that sticks to them, to blocks that met, and to blocks that a stopped strain rate would drive together. A
  // bond is an oscillating spring: once it holds, the clean-up takes no energy from it.
  std::vector<Part> parts_of_contacts() const {
    std::vector<Part> parts(of_.touches.size());
    if (of_.scene.settings.standard.impact == ImpactLaw::jump && !of_.rule.carries_acceleration()) put_springs(parts);
    for (std::size_t i = 0; i < parts.size(); ++i)
      if (of_.closed[i] && !has_spring(i)) parts[i] = Part::stops;
    return parts;
  }

  void put_springs(std::vector<Part>& parts) const {
    const std::vector<bool> hit = blocks_that_met();
    const Eigen::VectorXd stopped = rates(of_.smooth.rows, plus(before_, -1, of_.smooth.v));
    const double force = of_.scales.force > 0 ? of_.scales.force : of_.scales.momentum / of_.whole;
    const double least_work = kWorkOfOverlap * force * of_.scales.size;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (!of_.closed[i] || !has_spring(i)) continue;
      const double overlap = std::abs(stopped[static_cast<Eigen::Index>(2 * i)]) * of_.whole;
      const bool has_met =
          std::ranges::any_of(elements_of(i), [&](ElementIndex e) { return hit[static_cast<std::size_t>(e.value)]; });
      const bool is_of_cover = resolves_impact(of_.scene, of_.touches[i]);
      const bool sticks_to_cover =
          is_of_cover && (was_open(i) || (slip_held(i).sticks && !of_.smooth.laws[i].is_bonded));
      if (sticks_to_cover || normal(i) * overlap > least_work || (has_met && was_open(i)))
        parts[i] = Part::stops;
      else if (has_met && !is_of_cover)
        parts[i] = Part::passes_on;
    }
  }

  std::array<ElementIndex, 2> elements_of(std::size_t i) const {
    const Touch& touch = of_.touches[i];
    return {of_.scene.model.vertices[touch.vertex].element, of_.scene.model.vertices[touch.start].element};
  }

  // Blocks meet if a spring between them closes from a gap, or faster than in a step of free fall. The impulse reaches
  // all blocks that closing springs connect to them. Other closing springs are compressed by blocks that lie on them
  // from the start, without an impact. Returns one entry per element.
  std::vector<bool> blocks_that_met() const {
    const Model& model = of_.scene.model;
    std::vector<bool> hit(model.elements.size());
    std::vector<std::size_t> closing;
    Touches touches;
    for (std::size_t i = 0; i < of_.touches.size(); ++i) {
      if (!of_.closed[i] || !has_spring(i) || !was_open(i)) continue;
      closing.push_back(i);
      touches.push_back(of_.touches[i]);
    }
    if (closing.empty()) return hit;
    const ConnectedSets sets(model, pairs_of(model, touches), {});
    const auto at_start = vertices_at(model, of_.scene.reference, of_.start.q);
    std::vector<bool> is_hit(model.elements.size());  // by the number of a set
    for (const std::size_t i : closing) {
      if (!is_apart(of_.touches[i], at_start, of_.scales.size) && of_.speeds[i] >= -of_.scales.acceleration * of_.whole)
        continue;
      for (const ElementIndex e : elements_of(i))
        if (model.elements[e].can_move()) is_hit[sets.of(e)] = true;
    }
    for (const ElementIndex e : indices(model.elements)) hit[static_cast<std::size_t>(e.value)] = is_hit[sets.of(e)];
    return hit;
  }

  // A part of a step may resolve strains that the whole step does not, and pushes would give them a rate. The next part
  // would make a strain of it. Such blocks answer as rigid ones.
  Flexibility flexibility_of_part() const {
    Flexibility answering = of_.smooth.flexibility;
    const Table<ElementIndex, UnknownBlock> rigid = rigid_mass_inverses(of_.scene.bodies());
    for (const ElementIndex e : indices(answering.blocks))
      if (is_unresolved(of_.scene.bodies()[e], of_.whole)) answering.blocks[e] = rigid[e] / of_.rule.inertia.increment;
    answering.inverses = {};
    return answering;
  }

  PushedVelocities pushed_by(const PushAnswer& answer) const {
    return with_held_velocities(of_.scene, of_.smooth.q, before_, touches_, slips_, of_.time, of_.dt, answer);
  }

  // Returns the energy that contacts took in closing, beyond the energy stored in their springs.
  double energy_of_closing() const {
    const auto before = vertices_at(of_.scene.model, of_.scene.reference, of_.start.q);
    const auto after = vertices_at(of_.scene.model, of_.scene.reference, of_.smooth.q);
    double taken = 0;
    for (const std::size_t i : held_) {
      const Touch& touch = of_.touches[i];
      const ContactLaw& law = of_.smooth.laws[i];
      const double gap = gap_of(touch, after);
      const double kept = has_spring(i) ? std::max(0.0, law.rest_gap - gap) : 0;
      taken -= normal(i) * (gap - gap_of(touch, before) + kept);
    }
    return std::max(0.0, taken);
  }

  // The clean-up with the inertia that a step reaches may raise the kinetic energy, because that inertia is not the
  // mass. With the mass alone, the energy falls and contacts have no velocity either. If the energy would rise by more
  // than the closing contacts and the last step gave up, a mixture of both keeps it.
  PushedVelocities without_gain(PushedVelocities cleaned) const {
    const double most = kinetic_energy(of_.scene, before_) + of_.start.given_up + energy_of_closing();
    if (kinetic_energy(of_.scene, cleaned.v) <= most) return cleaned;
    const Flexibility mass = mass_flexibility(of_.scene);
    PushedVelocities calm = pushed_by({mass, of_.dt});
    const double left = most - kinetic_energy(of_.scene, calm.v);
    if (left <= 0) return calm;  // friction of slivers, or driven points
    const UnknownsTable change = plus(cleaned.v, -1, calm.v);
    const UnknownsTable pushed = momentum(of_.scene, change);
    const double slope = dot(calm.v, pushed);
    const double curvature = dot(change, pushed);
    const double part = (std::sqrt(slope * slope + 2 * curvature * left) - slope) / curvature;
    return {plus(calm.v, part, change), calm.given + part * (cleaned.given - calm.given)};
  }

  // If friction opposes the displacement of the step, a sticking contact keeps no tangential velocity, which would
  // reverse in each step. The impulse on a sliding one includes friction. Friction of DDA blocks opposes the end
  // velocity. Coulomb's law holds for the sum of force and impulse in the step in which they meet, and where the
  // clean-up makes up for a strain rate that was stopped.
  HeldSlip slip_held(std::size_t i) const {
    if (!of_.smooth.way_laws[i]) {
      const bool is_resting = of_.start.closed.of(of_.touches[i]) && !has_stopped_strain(of_.touches[i]);
      if (of_.smooth.laws[i].is_bonded || is_resting) return {};
      return {.coulomb = of_.smooth.laws[i].force.friction,
              .force = of_.smooth.forces.segment<2>(static_cast<Eigen::Index>(2 * i))};
    }
    if (of_.smooth.laws[i].is_bonded) return {.sticks = true};
    if (normal(i) <= 0) return {};
    const double tangential = of_.smooth.forces[static_cast<Eigen::Index>(2 * i + 1)];
    if (sticks(of_.smooth.laws[i], normal(i), tangential)) return {.sticks = true};
    return {.friction = tangential / normal(i)};
  }

  double passed_on_by(std::size_t i) const {
    return of_.smooth.laws[i].is_bonded ? 0 : of_.smooth.laws[i].force.friction;
  }

  const ClosingStep& of_;
  UnknownsTable before_;  ///< velocities of the smooth motion that the step resolves
  std::vector<std::size_t> held_;
  Touches touches_;  ///< those held
  std::vector<HeldSlip> slips_;
};

}  // namespace

CleanedVelocities cleaned_up(const ClosingStep& of) {
  return CleanUp(of).run();
}

bool is_apart(const Touch& touch, const Table<VertexIndex, Point>& vertices, double size) {
  return gap_of(touch, vertices) - touch.rest_gap > of_gaps::kTouching * size;
}

}  // namespace keyblock
