// Smooth motion, overlaps removed, clean-up, jump (src/README.md, a step of `standard`); the clean-up comes before the
// jump, so that it cannot undo a separation.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/time/standard_step.hpp"

#include <algorithm>
#include <cmath>

#include "contact/rows/gap.hpp"
#include "step/bodies/integrator.hpp"
#include "step/scene/acceleration.hpp"
#include "step/scene/contact_laws.hpp"
#include "step/scene/equilibrium.hpp"
#include "step/scene/touch_search.hpp"
#include "step/time/impact.hpp"
#include "step/time/ledger.hpp"
#include "step/time/smooth_solve.hpp"

namespace keyblock {
namespace {

constexpr int kMostHalvings = 2;
constexpr int kMostHalvingsOfYield = 5;  // flow that finds no balance in a long step finds it in a short one
// Each search adds the corners that the last solution made overlap; what is left after these is for the next step.
constexpr int kMostSearches = 4;
// Residual of the contact forces over the largest load on a block: few contacts reach the first, assemblies the second.
constexpr double kForceGoal = 1e-10;
constexpr double kForceAcceptable = 1e-6;
// In assemblies of more touches than `kFewPairs` the first is a setting, a millionth, far below what a step does to
// forces; and a thousandth, judged by what one force does to its own blocks in the step, is a gap of a thousandth of
// their free fall.
constexpr double kForceAcceptableOfMany = 1e-3;
// In the shortest part of a cut step a few pairs among many may go on changing sides: a hundredth is taken, or what
// changes the largest momentum by a ten-thousandth, and the pairs are told.
constexpr double kForceToleratedOfMany = 1e-2;
constexpr double kMomentumToleratedOfMany = 1e-4;
// A force below this is round-off of gaps in a short step.
constexpr double kLeastForceOfMany = 1e-8;
constexpr int kMostSystemsOfMany = 100;
// Of very many touches, forces that have not reached the goal after this many systems are taken where they are
// acceptable: on slopes that slide a pair or two of thousands goes on changing sides.
constexpr int kEnoughSystems = 12;
constexpr int kMostSystems = 40;
// Where nothing loads the blocks, forces come from momentum alone: the same over momentum / dt.
constexpr double kMomentumGoal = 1e-13;
constexpr double kMomentumAcceptable = 1e-9;
// Touches that overlap take part in the jump, and those with a gap below this share of block size: the corners of a
// flat impact meet within round-off.
constexpr double kMeeting = 1e-10;

// A body does not jump apart from itself: rigid motions leave such a touch as it is.
bool is_within_one_body(const StandardScene& scene, const Touch& touch) {
  return scene.groups.are_one_body(scene.model.vertices[touch.vertex].element,
                                   scene.model.vertices[touch.start].element);
}

struct Split {
  Touches smooth;
  Touches impacts;
  std::vector<double> impact_speeds;  ///< normal velocity at the start of the step, negative
};

// Bodies on covers resolve by themselves how an impact goes on: their own inertia near the touch takes part in the
// motion of the step, and nothing else is struck. Their rebound is that of their own elasticity: Newton's law with a
// restitution is one of whole blocks.
Split split(const StandardScene& scene, const Motion& start, const Touches& touches, double slow) {
  const ContactRows rows = contact_rows(scene.model, scene.reference, start.q, touches);
  const Eigen::VectorXd speeds = rates(rows, rigid_part(start.v));
  const bool springs_stop = scene.settings.standard.impact == ImpactLaw::springs;
  Split parts;
  for (std::size_t i = 0; i < touches.size(); ++i) {
    const double speed = speeds[static_cast<Eigen::Index>(2 * i)];
    if (springs_stop || speed >= -slow || start.closed.of(touches[i]) || is_within_one_body(scene, touches[i]) ||
        resolves_impact(scene, touches[i])) {
      parts.smooth.push_back(touches[i]);
    } else {
      parts.impacts.push_back(touches[i]);
      parts.impact_speeds.push_back(speed);
    }
  }
  return parts;
}

class Attempt {
 public:
  Attempt(const StandardScene& scene, const Motion& start, double time, double dt, bool is_last)
      : scene_(scene),
        is_last_(is_last),
        start_(start),
        time_(time),
        dt_(dt),
        rule_(step_rule(scene.settings, dt)),
        loads_(loads_at(scene, start.q, time + rule_.load_time * dt)) {
    scales_ = scales_of(scene, loads_, start.q, start.v);
    add_centrifugal_force(scene, start.v, loads_);
    scales_.momentum = std::max(scales_.momentum, dt * driving_force(scene, start, time + dt, dt));
    found_ = touches_of(scene, start, scales_, dt);
    leave_overlaps(scene, start, scales_, found_.touches);
    least_force_ = kForceGoal * scales_.force + kMomentumGoal * scales_.momentum / dt;
  }

  StandardStep run() {
    move_smoothly();
    step_.touches = parts_.smooth;
    step_.touches.insert(step_.touches.end(), parts_.impacts.begin(), parts_.impacts.end());
    step_.undecided = smooth_.undecided;
    step_.residual = scales_.force > 0 ? smooth_.residual / scales_.force : 0;
    step_.converged = smooth_.converged;
    if (!step_.converged) return std::move(step_);
    if (!smooth_.is_tolerated) step_.undecided.clear();
    const Touches closed = closed_touches();
    step_.motion.q = smooth_.q;
    step_.motion.a = smooth_.a;
    step_.motion.points = smooth_.points;
    step_.motion.bonds = smooth_.bonds;
    step_.motion.constraints = smooth_.constraints;
    const std::vector<std::size_t> held = to_be_held();
    Touches held_touches;
    std::vector<HeldSlip> slips;
    for (std::size_t i : held) {
      held_touches.push_back(parts_.smooth[i]);
      slips.push_back(slip_held(i));
    }
    step_.motion.v = cleaned_up(held_touches, slips, start_.given_up + energy_of_closing(held));
    if (one_resolves_impact(held_touches))
      step_.motion.given_up = std::max(0.0, kinetic_energy(scene_, smooth_.v) - kinetic_energy(scene_, step_.motion.v));
    const UnknownsTable cleaned = step_.motion.v;
    if (!parts_.impacts.empty()) strike(closed);
    remember();
    if (rule_.carries_acceleration()) step_.motion.a = with_held_at_ease(scene_, step_.motion);
    if (scene_.settings.ledger == Bookkeeping::on)
      step_.account = account_of(scene_, {start_, loads_, parts_.smooth, StepConstraints(scene_, start_, time_, dt_),
                                          smooth_, cleaned, step_.motion, dt_, rule_});
    return std::move(step_);
  }

 private:
  // Again where blocks came to overlap at corners that nobody reckoned with.
  void move_smoothly() {
    const bool is_many = found_.touches.size() > FrictionalProblem::kFewPairs;
    if (is_many) least_force_ = std::max(least_force_, kLeastForceOfMany * scales_.force);
    const double goal =
        is_many ? std::max(least_force_, scene_.settings.standard.force_tolerance * scales_.force) : least_force_;
    const double share = is_many ? kForceAcceptableOfMany : kForceAcceptable;
    ForceTolerance tolerance{goal, std::max(share * scales_.force, kMomentumAcceptable * scales_.momentum / dt_)};
    if (is_many && is_last_)
      tolerance.tolerated =
          std::max(kForceToleratedOfMany * scales_.force, kMomentumToleratedOfMany * scales_.momentum / dt_);
    for (int search = 0; search < kMostSearches; ++search) {
      if (is_many) tolerance.most_systems = kMostSystemsOfMany;
      if (found_.touches.size() > FrictionalProblem::kVeryManyPairs) {
        tolerance.most_systems = std::max(0, kMostSystems - step_.solves);
        tolerance.enough_systems = std::max(0, kEnoughSystems - step_.solves);
      }
      parts_ = split(scene_, start_, found_.touches, slow_speed(scene_, scales_, start_.v, dt_));
      const SmoothMotion before = std::move(smooth_);
      smooth_ = smooth_solve(scene_, start_, loads_, parts_.smooth, tolerance, time_, dt_, rule_,
                             search > 0 ? &before : nullptr);
      step_.solves += smooth_.solves;
      step_.fallbacks += smooth_.sweeps > 0 ? 1 : 0;
      if (!smooth_.converged) return;
      const auto end = vertices_at(scene_.model, scene_.reference, smooth_.q);
      Touches fresh = newly_overlapping(scene_, start_, end, found_, scales_);
      if (fresh.empty()) return;
      leave_overlaps(scene_, start_, scales_, fresh);
      found_.touches.insert(found_.touches.end(), fresh.begin(), fresh.end());
    }
  }

  double normal(std::size_t i) const { return smooth_.forces[static_cast<Eigen::Index>(2 * i)]; }

  // A force below the residual is none; a bond may pull.
  bool is_closed(std::size_t i) const {
    return std::abs(normal(i)) > least_force_ || smooth_.bonds.contains(parts_.smooth[i].facing);
  }

  Touches closed_touches() const {
    Touches closed;
    for (std::size_t i = 0; i < parts_.smooth.size(); ++i)
      if (is_closed(i)) closed.push_back(parts_.smooth[i]);
    return closed;
  }

  // Those whose gap decides what they do in the step: multipliers, and what has just closed, or sticks, on bodies on
  // covers, which would be thrown back. A bond is a spring that swings: it loses nothing to the clean-up once it holds.
  std::vector<std::size_t> to_be_held() const {
    const bool springs_throw_back = scene_.settings.standard.impact == ImpactLaw::jump && !rule_.carries_acceleration();
    std::vector<std::size_t> held;
    for (std::size_t i = 0; i < parts_.smooth.size(); ++i) {
      if (!is_closed(i)) continue;
      const Touch& touch = parts_.smooth[i];
      const bool has_spring = smooth_.laws[i].normal_compliance > 0;
      const bool has_met = !start_.closed.of(touch) || (slip_held(i).sticks && !smooth_.laws[i].is_bonded);
      if (!has_spring || (springs_throw_back && has_met && resolves_impact(scene_, touch))) held.push_back(i);
    }
    return held;
  }

  bool one_resolves_impact(const Touches& touches) const {
    return std::ranges::any_of(touches, [&](const Touch& touch) { return resolves_impact(scene_, touch); });
  }

  // What contacts took as they closed, beyond what their springs keep.
  double energy_of_closing(const std::vector<std::size_t>& held) const {
    const auto before = vertices_at(scene_.model, scene_.reference, start_.q);
    const auto after = vertices_at(scene_.model, scene_.reference, smooth_.q);
    double taken = 0;
    for (const std::size_t i : held) {
      const Touch& touch = parts_.smooth[i];
      const ContactLaw& law = smooth_.laws[i];
      const double gap = gap_of(touch, after);
      const double kept = law.normal_compliance > 0 ? std::max(0.0, law.rest_gap - gap) : 0;
      taken -= normal(i) * (gap - gap_of(touch, before) + kept);
    }
    return std::max(0.0, taken);
  }

  // The inertia that a step reaches is not that of the kinetic energy, which may therefore rise. Where mass alone
  // answers it falls, and contacts have no velocity either: where it would rise by more than contacts took as they
  // closed, and the step before gave up, there is as much of that as keeps it.
  UnknownsTable cleaned_up(const Touches& held, const std::vector<HeldSlip>& slips, double at_most) const {
    const auto answered_by = [&](const Flexibility& answer) {
      return with_held_velocities(scene_, smooth_.q, smooth_.v, held, slips, time_, dt_, answer);
    };
    UnknownsTable cleaned = answered_by(smooth_.flexibility);
    if (!one_resolves_impact(held)) return cleaned;
    const double most = kinetic_energy(scene_, smooth_.v) + at_most;
    if (kinetic_energy(scene_, cleaned) <= most) return cleaned;
    const UnknownsTable calm = answered_by(mass_flexibility(scene_));
    const double left = most - kinetic_energy(scene_, calm);
    if (left <= 0) return calm;  // friction of slivers, or driven points
    const UnknownsTable change = plus(cleaned, -1, calm);
    const UnknownsTable pushed = momentum(scene_, change);
    const double slope = dot(calm, pushed);
    const double curvature = dot(change, pushed);
    return plus(calm, (std::sqrt(slope * slope + 2 * curvature * left) - slope) / curvature, change);
  }

  // Where friction is one of the way of the step, a contact that sticks keeps no velocity along its edge, which would
  // turn over in each step, and the impulse on one that slides rubs. Blocks, whose friction is one of the velocity at
  // the end, come to rest against each other in a step or two.
  HeldSlip slip_held(std::size_t i) const {
    if (!smooth_.way_laws[i]) return {};
    if (smooth_.laws[i].is_bonded) return {.sticks = true};
    if (normal(i) <= 0) return {};
    const double tangential = smooth_.forces[static_cast<Eigen::Index>(2 * i + 1)];
    if (sticks(smooth_.laws[i], normal(i), tangential)) return {.sticks = true};
    return {.friction = tangential / normal(i)};
  }

  void strike(const Touches& closed) {
    drop_passed();
    const auto vertices = vertices_at(scene_.model, scene_.reference, smooth_.q);
    const Eigen::VectorXd speeds =
        rates(contact_rows(scene_.model, scene_.reference, smooth_.q, parts_.impacts), rigid_part(step_.motion.v));
    Impacts impacts;
    std::vector<std::size_t> met;
    for (std::size_t i = 0; i < parts_.impacts.size(); ++i) {
      const double gap = gap_of(parts_.impacts[i], vertices) - parts_.impacts[i].rest_gap;
      if (gap > kMeeting * scales_.size) continue;
      met.push_back(i);
      impacts.meetings.push_back(meeting(parts_.impacts[i], parts_.impact_speeds[i],
                                         speeds[static_cast<Eigen::Index>(2 * i)], std::max(0.0, -gap)));
    }
    if (impacts.meetings.empty()) return;
    impacts.closed = closed;
    std::erase_if(impacts.closed, [&](const Touch& touch) { return is_within_one_body(scene_, touch); });
    const Flexibility flexibility = impact_flexibility(scene_, smooth_.flexibility, rule_);
    impacts.bonds = smooth_.bonds;
    impacts.slow = slow_speed(scene_, scales_, start_.v, dt_);
    Jump jump = after_jump(scene_, smooth_.q, step_.motion.v, impacts, flexibility);
    for (std::size_t i : jump.undecided) step_.undecided.push_back(parts_.smooth.size() + met[i]);
    step_.motion.v = std::move(jump.v);
    if (!jump.undecided.empty())  // points that are held do not take part in what is left open
      step_.motion.v =
          with_held_velocities(scene_, smooth_.q, std::move(step_.motion.v), {}, {}, time_, dt_, smooth_.flexibility);
    Separated separated = without_overlap(scene_, std::move(jump.q), parts_.impacts, others(), smooth_.q, flexibility);
    step_.motion.q = with_points_in_place(scene_, std::move(separated.q), time_ + dt_, flexibility);
    step_.solves += jump.solves + separated.solves;
    step_.locked_overlaps += separated.locked;
  }

  // What the ways of the jump and of the separation may not drive into one another. A corner beside its edge is free.
  Touches others() const {
    const auto vertices = vertices_at(scene_.model, scene_.reference, smooth_.q);
    Touches others;
    for (std::size_t i = 0; i < parts_.smooth.size(); ++i) {
      const Touch& touch = parts_.smooth[i];
      if (!is_within_one_body(scene_, touch) && (is_closed(i) || lies_over_edge(touch, vertices)))
        others.push_back(touch);
    }
    return others;
  }

  // A corner that has run past the end of its edge within the step meets the next edge in the next step: the line that
  // it left would push it in a direction in which there is no face.
  void drop_passed() {
    const auto vertices = vertices_at(scene_.model, scene_.reference, smooth_.q);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < parts_.impacts.size(); ++i) {
      if (!lies_over_edge(parts_.impacts[i], vertices)) continue;
      parts_.impacts[kept] = parts_.impacts[i];
      parts_.impact_speeds[kept++] = parts_.impact_speeds[i];
    }
    parts_.impacts.resize(kept);
    parts_.impact_speeds.resize(kept);
  }

  // Speed where the surfaces met, not at the end of the step: v² = v1² + 2 a d with a the acceleration of the step and
  // d the overshoot; d was covered at the mean of both speeds.
  Meeting meeting(const Touch& touch, double at_start, double at_end, double overshoot) const {
    if (at_end >= 0) return {touch, 0, 0};
    const double acceleration = (at_end - at_start) / dt_;
    const double at_surface = std::sqrt(std::max(0.0, at_end * at_end + 2 * acceleration * overshoot));
    return {touch, std::min(dt_, 2 * overshoot / (at_surface - at_end)), -at_end - at_surface};
  }

  // Springs have the force of the step; at its end they are pressed by the gap.
  void remember() {
    const auto end = vertices_at(scene_.model, scene_.reference, smooth_.q);
    const Eigen::VectorXd way = rates(smooth_.rows, plus(smooth_.q, -1, start_.q));
    std::vector<ClosedContact> closed;
    for (std::size_t i = 0; i < parts_.smooth.size(); ++i) {
      if (!is_closed(i)) continue;
      const auto t = static_cast<Eigen::Index>(2 * i + 1);
      const ContactLaw& law = smooth_.laws[i];
      const Touch& touch = parts_.smooth[i];
      ContactMemory memory = memory_of(law, normal(i), smooth_.forces[t], way[t], start_.closed.of(touch));
      if (law.normal_compliance > 0) {
        const double by_gap = std::max(law.force.least, (law.rest_gap - gap_of(touch, end)) / law.normal_compliance);
        memory.compression = by_gap * law.normal_compliance;
        if (!smooth_.rate_laws[i]) memory.normal_at_end = by_gap;
      }
      closed.push_back({touch, memory});
    }
    step_.motion.closed = ClosedContacts(std::move(closed));
  }

  const StandardScene& scene_;
  bool is_last_;  ///< no cut can follow
  const Motion& start_;
  double time_;
  double dt_;
  StepRule rule_;
  UnknownsTable loads_;
  Scales scales_;
  FoundTouches found_;
  double least_force_ = 0;
  Split parts_;
  SmoothMotion smooth_;
  StandardStep step_;
};

StandardStep in_parts(const StandardScene& scene, const Motion& start, double time, double dt, int halvings_left) {
  StandardStep whole =
      Attempt(scene, start, time, dt, halvings_left == 0 && scene.settings.step_control == StepControl::constant).run();
  whole.least = dt;
  if (whole.converged || halvings_left == 0) return whole;
  StandardStep first = in_parts(scene, start, time, dt / 2, halvings_left - 1);
  if (!first.converged) return first;
  StandardStep second = in_parts(scene, first.motion, time + dt / 2, dt / 2, halvings_left - 1);
  second.solves += first.solves + whole.solves;
  second.fallbacks += first.fallbacks + whole.fallbacks;
  second.halvings += first.halvings + 1;
  second.locked_overlaps += first.locked_overlaps;
  if (second.undecided.empty()) second.undecided = first.undecided;
  second.account += first.account;
  second.residual = std::max(first.residual, second.residual);
  second.least = std::min(first.least, second.least);
  return second;
}

}  // namespace

StandardStep standard_step(const StandardScene& scene, const Motion& start, double time, double dt) {
  return in_parts(scene, start, time, dt, may_yield(scene) ? kMostHalvingsOfYield : kMostHalvings);
}

}  // namespace keyblock
