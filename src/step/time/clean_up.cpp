// Selects the contacts whose velocity must stop, and the friction of their impulses; see clean_up.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/time/clean_up.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "contact/find/connected_sets.hpp"
#include "contact/rows/gap.hpp"
#include "step/bodies/unresolved_strain.hpp"
#include "step/newton/tolerances.hpp"
#include "step/time/impulse_energy.hpp"
#include "step/time/ledger.hpp"

namespace keyblock {
namespace {

using namespace tolerances;

// Work of a contact force over twice the overlap that stopped strain rates would make in the next step. The unit is the
// largest load, or what stops the largest momentum in a step, times the size of blocks. Slivers, which strain fast,
// stay below it; more would cost time.
constexpr double kWorkOfOverlap = 3e-6;

// Surfaces have parted within a step by so many compressions, or only swung. At 1, springs of slopes that slide, which
// swing, met in one frame and not in another. At 100, walls that rock kept overlaps.
constexpr double kPartedInStep = 10;

// Pushes are made anew with the contacts that they would close, at most so often: what is left is small.
constexpr int kMostRounds = 4;

class CleanUp {
 public:
  explicit CleanUp(const ClosingStep& of) : of_(of), before_(of.smooth.v) {
    if (stops_strain()) stop_unresolved(of_.scene.bodies(), of_.whole, before_);
    const std::vector<Part> parts = parts_of_contacts();
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (parts[i] == Part::none) continue;
      hold(i, parts[i] == Part::stops ? slip_held(i) : HeldSlip{.passes_on = passed_on_by(i)});
    }
  }

  CleanedVelocities run() {
    CleanedVelocities cleaned = velocities();
    cleaned.may_open.resize(of_.touches.size());
    for (std::size_t i = 0; i < held_.size(); ++i)
      cleaned.may_open[held_[i]] = slips_[i].has_law_of_impulse() && !sets().has_bond(held_[i]);
    return cleaned;
  }

 private:
  CleanedVelocities velocities() {
    PushedVelocities pushed = pushed_in_step();
    for (int round = 1; round < kMostRounds && hold_closing(pushed.v); ++round) pushed = pushed_in_step();
    const bool has_inertia_of_step =
        std::ranges::any_of(touches_, [&](const Touch& touch) { return resolves_impact(of_.scene, touch); });
    if (!has_inertia_of_step) {
      if (!held_.empty()) pushed.given *= sets().take_gain(before_, held_, pushed.v);
      return {std::move(pushed.v), pushed.given};
    }
    pushed = without_gain(std::move(pushed));
    // Pushes that the mass answers give rates to strains, of which the next step would make strains.
    if (stops_strain()) stop_unresolved(of_.scene.bodies(), of_.whole, pushed.v);
    const double given_up = kinetic_energy(of_.scene, before_) - kinetic_energy(of_.scene, pushed.v);
    return {std::move(pushed.v), pushed.given, std::max(0.0, given_up)};
  }

  PushedVelocities pushed_in_step() const {
    const double per_force = of_.rule.end_velocity.increment;
    return stops_strain() && of_.dt < of_.whole ? pushed_by({flexibility_of_part(), per_force})
                                                : pushed_by({of_.smooth.flexibility, per_force});
  }

  void hold(std::size_t i, const HeldSlip& slip) {
    held_.push_back(i);
    touches_.push_back(of_.touches[i]);
    slips_.push_back(slip);
  }

  // Impulses go on through closed contacts that they would close faster than before, by more than the compression in
  // half a step. Returns true if there are more of them.
  bool hold_closing(const UnknownsTable& pushed) {
    if (!has_met_) return false;
    std::vector<bool> is_held(of_.touches.size());
    for (const std::size_t i : held_) is_held[i] = true;
    const Eigen::VectorXd before = rates(of_.smooth.rows, before_);
    const Eigen::VectorXd after = rates(of_.smooth.rows, pushed);
    const std::size_t had = held_.size();
    for (std::size_t i = 0; i < of_.touches.size(); ++i) {
      if (is_held[i] || !of_.closed[i] || !has_spring(i) || sets().has_bond(i)) continue;
      if (resolves_impact(of_.scene, of_.touches[i])) continue;
      const auto n = static_cast<Eigen::Index>(2 * i);
      const double way = of_.whole / 2 * (std::min(0.0, before[n]) - after[n]);
      if (way > of_.smooth.laws[i].normal_compliance * normal(i)) hold(i, {.passes_on = passed_on_by(i)});
    }
    return held_.size() > had;
  }

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
  std::vector<Part> parts_of_contacts() {
    std::vector<Part> parts(of_.touches.size());
    if (of_.scene.settings.standard.impact == ImpactLaw::jump && !of_.rule.carries_acceleration()) put_springs(parts);
    for (std::size_t i = 0; i < parts.size(); ++i)
      if (of_.closed[i] && !has_spring(i)) parts[i] = Part::stops;
    return parts;
  }

  void put_springs(std::vector<Part>& parts) {
    const std::vector<bool> hit = blocks_that_met();
    has_met_ = std::ranges::find(hit, true) != hit.end();
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

  // Blocks meet if a spring between them closes from a gap, faster than in a step of free fall, or after its surfaces
  // parted within the step. So do all blocks that closing springs connect to them. Other closing springs are compressed
  // by blocks that lie on them from the start, without an impact. Returns one entry per element.
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
    const Eigen::VectorXd speeds = rates(of_.smooth.rows, of_.start.v);
    std::vector<bool> is_hit(model.elements.size());  // by the number of a set
    for (const std::size_t i : closing) {
      const bool is_fast = of_.speeds[i] < -of_.scales.acceleration * of_.whole;
      if (!is_fast && !is_apart(of_.touches[i], at_start, of_.scales.size) && !came_back(i, at_start, speeds)) continue;
      for (const ElementIndex e : elements_of(i))
        if (model.elements[e].can_move()) is_hit[sets.of(e)] = true;
    }
    for (const ElementIndex e : indices(model.elements)) hit[static_cast<std::size_t>(e.value)] = is_hit[sets.of(e)];
    return hit;
  }

  // True if the surfaces began to part, by much more than the force at the end compresses them.
  bool came_back(std::size_t i, const Table<VertexIndex, Point>& at_start, const Eigen::VectorXd& speeds) const {
    const double speed = speeds[static_cast<Eigen::Index>(2 * i)];
    const ContactLaw& law = of_.smooth.laws[i];
    const double parted = gap_of(of_.touches[i], at_start) - law.rest_gap + of_.dt / 2 * speed;
    return speed > 0 && parted > kPartedInStep * law.normal_compliance * normal(i);
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

  double energy_of_closing_contacts() const {
    const auto at_start = vertices_at(of_.scene.model, of_.scene.reference, of_.start.q);
    const auto at_end = vertices_at(of_.scene.model, of_.scene.reference, of_.smooth.q);
    double taken = 0;
    for (const std::size_t i : held_) taken += energy_of_closing(of_, i, at_start, at_end);
    return std::max(0.0, taken);
  }

  // The clean-up with the inertia that a step reaches may raise the kinetic energy, because that inertia is not the
  // mass. With the mass alone, the energy falls and contacts have no velocity either. If the energy would rise by more
  // than the closing contacts and the last step gave up, a mixture of both keeps it.
  PushedVelocities without_gain(PushedVelocities cleaned) const {
    const double most = kinetic_energy(of_.scene, before_) + of_.start.given_up + energy_of_closing_contacts();
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
      ForceLaw law{of_.smooth.laws[i].force.friction};
      if (sets().has_bond(i)) law.least = kBilateral.least;
      return {.of_sum = law, .force = of_.smooth.forces.segment<2>(static_cast<Eigen::Index>(2 * i))};
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

  const PushedSets& sets() const {
    if (!sets_) sets_.emplace(of_);
    return *sets_;
  }

  const ClosingStep& of_;
  mutable std::optional<PushedSets> sets_;  ///< once needed
  bool has_met_ = false;                    ///< any two blocks
  UnknownsTable before_;                    ///< velocities of the smooth motion that the step resolves
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
