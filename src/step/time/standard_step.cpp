// Makes a step: smooth motion, clean-up, jump, removal of overlaps (docs/theory/03-time-integration.md, 3.8). The
// clean-up comes before the jump, so that it cannot undo a separation.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/time/standard_step.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "contact/rows/gap.hpp"
#include "contact/solve/frictional_problem.hpp"
#include "step/bodies/integrator.hpp"
#include "step/newton/tolerances.hpp"
#include "step/scene/acceleration.hpp"
#include "step/scene/contact_laws.hpp"
#include "step/scene/equilibrium.hpp"
#include "step/scene/set_shares.hpp"
#include "step/scene/touch_search.hpp"
#include "step/time/clean_up.hpp"
#include "step/time/ledger.hpp"
#include "step/time/smooth_solve.hpp"
#include "step/time/strike.hpp"

namespace keyblock {
namespace {

using namespace tolerances;

struct Split {
  Touches smooth;
  std::vector<double> smooth_speeds;  ///< normal velocity at the start of the step; 0 if no impact is possible
  Touches impacts;
  std::vector<double> impact_speeds;  ///< normal velocity at the start of the step, negative
};

// NMM bodies resolve impacts by themselves: their inertia near the contact takes part in the motion of the step, and
// nothing else is hit. Elasticity governs their rebound. Newton's law of restitution is one of whole blocks.
Split split(const StandardScene& scene, const Motion& start, const Touches& touches, double slow) {
  const bool springs_stop = scene.settings.standard.impact == ImpactLaw::springs;
  std::vector<bool> may_strike;
  Touches meeting;
  for (const Touch& touch : touches) {
    may_strike.push_back(!springs_stop && !start.closed.of(touch) && !is_within_one_body(scene, touch) &&
                         !resolves_impact(scene, touch));
    if (may_strike.back()) meeting.push_back(touch);
  }
  const ContactRows rows = contact_rows(scene.model, scene.reference, start.q, meeting);
  const Eigen::VectorXd speeds = rates(rows, rigid_part(start.v));
  Split parts;
  Eigen::Index row = 0;
  for (std::size_t i = 0; i < touches.size(); ++i) {
    const Eigen::Index own = row;
    if (may_strike[i]) row += 2;
    if (!may_strike[i] || speeds[own] >= -slow) {
      parts.smooth.push_back(touches[i]);
      parts.smooth_speeds.push_back(may_strike[i] ? speeds[own] : 0);
    } else {
      parts.impacts.push_back(touches[i]);
      parts.impact_speeds.push_back(speeds[own]);
    }
  }
  return parts;
}

// Returns loaded contacts, and contacts closed to within kTouching without load: an impact passes through them at once.
Touches touching(const StandardScene& scene, const UnknownsTable& q, const Touches& touches, double size,
                 const std::vector<bool>& bears) {
  const auto vertices = vertices_at(scene.model, scene.reference, q);
  Touches result;
  for (std::size_t i = 0; i < touches.size(); ++i)
    if (bears[i] || (!is_apart(touches[i], vertices, size) && lies_over_edge(touches[i], vertices)))
      result.push_back(touches[i]);
  return result;
}

double share_of(const ForceTolerance& tolerance, const Model& model, const Touch& touch) {
  return tolerance.share_of(model.vertices[touch.vertex].element, model.vertices[touch.start].element);
}

class Attempt {
 public:
  Attempt(const StandardScene& scene, const Motion& start, double time, double dt, double whole, bool is_last)
      : scene_(scene),
        is_last_(is_last),
        start_(start),
        time_(time),
        dt_(dt),
        whole_(whole),
        rule_(step_rule(scene.settings, dt)),
        loads_(mean_loads(scene, start.q, time + rule_.load_time * dt, dt)) {
    scales_ = scales_of(scene, loads_, start.q, start.v);
    if (scales_.force == 0) scales_.force = reference_of_stress(scene, start.q);
    add_centrifugal_force(scene, start.v, loads_);
    scales_.momentum = std::max(scales_.momentum, dt * driving_force(scene, start, time + dt, dt));
    found_ = touches_of(scene, start, scales_, dt);
    leave_overlaps(scene, start, scales_, found_);
    least_force_ = of_steps::kForceGoal * scales_.force + of_steps::kMomentumGoal * scales_.momentum / dt;
    tolerance_.shares = shares_of_sets(scene, start, loads_, found_, dt);
  }

  StandardStep run() {
    move_smoothly();
    step_.touches = parts_.smooth;
    step_.touches.insert(step_.touches.end(), parts_.impacts.begin(), parts_.impacts.end());
    step_.undecided = smooth_.undecided;
    step_.residual = scales_.force > 0 ? smooth_.residual / scales_.force : 0;
    if (smooth_.worst && *smooth_.worst < parts_.smooth.size()) step_.worst = parts_.smooth[*smooth_.worst];
    step_.converged = smooth_.converged;
    step_.end = smooth_.end;
    if (!step_.converged) return std::move(step_);
    if (!smooth_.is_tolerated) step_.undecided.clear();
    step_.motion.q = smooth_.q;
    step_.motion.a = smooth_.a;
    step_.motion.points = smooth_.points;
    step_.motion.bonds = smooth_.bonds;
    step_.motion.constraints = smooth_.constraints;
    put_closed();
    CleanedVelocities of_contacts = cleaned_up({.scene = scene_,
                                                .start = start_,
                                                .smooth = smooth_,
                                                .rule = rule_,
                                                .scales = scales_,
                                                .touches = parts_.smooth,
                                                .speeds = parts_.smooth_speeds,
                                                .closed = closed_,
                                                .time = time_,
                                                .dt = dt_,
                                                .whole = whole_});
    step_.motion.v = std::move(of_contacts.v);
    step_.motion.given_up = of_contacts.given_up;
    may_open_ = std::move(of_contacts.may_open);
    SupportWork given{of_contacts.given, 0};
    const UnknownsTable cleaned = step_.motion.v;
    if (!parts_.impacts.empty())
      given.jump = strike({scene_, start_, smooth_, rule_, time_, dt_, slow_speed(scene_, scales_, start_.v, whole_),
                           scales_.size, parts_.smooth.size()},
                          {std::move(parts_.impacts), std::move(parts_.impact_speeds)},
                          {touching(scene_, smooth_.q, parts_.smooth, scales_.size, closed_),
                           [&](const UnknownsTable& after_jump) { return others(after_jump); }},
                          step_);
    remember();
    if (rule_.carries_acceleration()) step_.motion.a = with_held_at_ease(scene_, step_.motion);
    if (scene_.settings.ledger == Bookkeeping::on)
      step_.account = account_of(scene_, {start_, loads_, parts_.smooth, StepConstraints(scene_, start_, time_, dt_),
                                          smooth_, cleaned, step_.motion, dt_, rule_, given});
    return std::move(step_);
  }

 private:
  // Repeats the solution if blocks overlap at corners that were not considered.
  void move_smoothly() {
    const bool is_many = found_.size() > FrictionalProblem::kFewPairs;
    if (is_many) least_force_ = std::max(least_force_, of_steps::kLeastForceOfMany * scales_.force);
    const double goal =
        is_many ? std::max(least_force_, scene_.settings.standard.force_tolerance * scales_.force) : least_force_;
    const double share = is_many ? of_steps::kForceAcceptableOfMany : of_steps::kForceAcceptable;
    tolerance_.goal = goal;
    tolerance_.acceptable = std::max(share * scales_.force, of_steps::kMomentumAcceptable * scales_.momentum / dt_);
    if (is_many && is_last_)
      tolerance_.tolerated = std::max(of_steps::kForceToleratedOfMany * scales_.force,
                                      of_steps::kMomentumToleratedOfMany * scales_.momentum / dt_);
    for (int search = 0; search < of_steps::kMostSearches; ++search) {
      parts_ = split(scene_, start_, found_, slow_speed(scene_, scales_, start_.v, whole_));
      const SmoothMotion before = std::move(smooth_);
      smooth_ = smooth_solve(scene_, start_, loads_, parts_.smooth, tolerance_, time_, dt_, rule_,
                             search > 0 ? &before : nullptr);
      step_.solves += smooth_.solves;
      step_.fallbacks += smooth_.fallbacks > 0 ? 1 : 0;
      if (!smooth_.converged) return;
      const auto end = vertices_at(scene_.model, scene_.reference, smooth_.q);
      Touches fresh = newly_overlapping(scene_, start_, end, found_, scales_);
      if (fresh.empty()) return;
      leave_overlaps(scene_, start_, scales_, fresh);
      found_.insert(found_.end(), fresh.begin(), fresh.end());
    }
  }

  double normal(std::size_t i) const { return smooth_.forces[static_cast<Eigen::Index>(2 * i)]; }

  // A force below the residual counts as zero; a bond may pull.
  void put_closed() {
    for (std::size_t i = 0; i < parts_.smooth.size(); ++i)
      closed_.push_back(std::abs(normal(i)) > share_of(tolerance_, scene_.model, parts_.smooth[i]) * least_force_ ||
                        smooth_.bonds.contains(parts_.smooth[i].facing));
  }

  // Lists the contacts that neither jump nor separation may drive into one another. These are closed contacts, corners
  // over their edge before or after the jump, and contacts that overlap only after it.
  Touches others(const UnknownsTable& after_jump) const {
    const auto vertices = vertices_at(scene_.model, scene_.reference, smooth_.q);
    const auto jumped = vertices_at(scene_.model, scene_.reference, after_jump);
    Touches others;
    for (std::size_t i = 0; i < parts_.smooth.size(); ++i) {
      const Touch& touch = parts_.smooth[i];
      if (closed_[i] || lies_over_edge(touch, vertices) || lies_over_edge(touch, jumped)) others.push_back(touch);
    }
    std::ranges::copy(newly_overlapping(scene_, start_, jumped, found_, scales_), std::back_inserter(others));
    std::erase_if(others, [&](const Touch& touch) { return is_within_one_body(scene_, touch); });
    return others;
  }

  // Springs have the force of the step; at its end the gap compresses them.
  void remember() {
    const auto end = vertices_at(scene_.model, scene_.reference, smooth_.q);
    const Eigen::VectorXd way = rates(smooth_.rows, plus(smooth_.q, -1, start_.q));
    const std::vector<bool> opens = opened_at(end);
    std::vector<ClosedContact> closed;
    for (std::size_t i = 0; i < parts_.smooth.size(); ++i) {
      if (!closed_[i] || opens[i]) continue;
      const auto t = static_cast<Eigen::Index>(2 * i + 1);
      const ContactLaw& law = smooth_.laws[i];
      const Touch& touch = parts_.smooth[i];
      const ContactMemory* before = start_.closed.of(touch);
      ContactMemory memory = memory_of(law, normal(i), smooth_.forces[t], way[t], before);
      if (law.normal_compliance > 0) {
        const double by_gap = std::max(law.force.least, (law.rest_gap - gap_of(touch, end)) / law.normal_compliance);
        memory.compression = by_gap * law.normal_compliance;
        memory.removed_in = whole_;
        if (!smooth_.rate_laws[i]) memory.normal_at_end = by_gap;
      }
      closed.push_back({touch, memory});
    }
    step_.motion.closed = ClosedContacts(std::move(closed));
  }

  // A contact opens if its impulse lets it, and its surfaces will part within half a step. As a closed one it would
  // stop them by a force that acts across the gap.
  std::vector<bool> opened_at(const Table<VertexIndex, Point>& end) const {
    std::vector<bool> opens = may_open_;
    if (std::ranges::find(opens, true) == opens.end()) return opens;
    const Eigen::VectorXd speeds = rates(smooth_.rows, step_.motion.v);
    for (std::size_t i = 0; i < opens.size(); ++i) {
      const ContactLaw& law = smooth_.laws[i];
      const double way = whole_ / 2 * speeds[static_cast<Eigen::Index>(2 * i)];
      opens[i] = opens[i] && law.normal_compliance > 0 && gap_of(parts_.smooth[i], end) - law.rest_gap + way > 0;
    }
    return opens;
  }

  const StandardScene& scene_;
  bool is_last_;  ///< no cut can follow
  const Motion& start_;
  double time_;
  double dt_;
  double whole_;  ///< whole step: slow speeds in it are slow in its parts too
  StepRule rule_;
  UnknownsTable loads_;
  Scales scales_;
  Touches found_;
  double least_force_ = 0;
  ForceTolerance tolerance_;
  Split parts_;
  SmoothMotion smooth_;
  std::vector<bool> closed_;    ///< per contact of the smooth motion
  std::vector<bool> may_open_;  ///< per contact: true if an impulse may have opened it
  StandardStep step_;
};

// Joins two parts of a step that replace the discarded attempt `tried`. `last`: length of the second part.
StandardStep in_two(const StandardStep& tried, const StandardStep& first, StandardStep second, double last) {
  second.solves += first.solves + tried.solves;
  second.fallbacks += first.fallbacks + tried.fallbacks;
  second.halvings += first.halvings;
  second.locked_overlaps += first.locked_overlaps;
  if (second.undecided.empty() && !first.undecided.empty()) {
    second.undecided = first.undecided;
    second.touches = first.touches;
  }
  second.account += first.account;
  second.keep_larger_residual(first);
  second.least = std::min(first.least, second.least);
  if (first.struck > 0) second.struck = first.struck + last;
  return second;
}

// Makes a step, or a part of it, of `dt`. If forces do not settle, it is halved repeatedly.
class Halves {
 public:
  Halves(const StandardScene& scene, double whole) : scene_(scene), whole_(whole) {}

  StandardStep run(const Motion& start, double time, double dt) const {
    return run(start, time, dt, may_yield(scene_) ? of_steps::kMostHalvingsOfYield : of_steps::kMostHalvings);
  }

 private:
  StandardStep run(const Motion& start, double time, double dt, int left) const {
    const bool is_last = left == 0 && scene_.settings.step_control == StepControl::constant;
    StandardStep whole = Attempt(scene_, start, time, dt, whole_, is_last).run();
    whole.least = dt;
    if (whole.converged || left == 0) return whole;
    const StandardStep first = run(start, time, dt / 2, left - 1);
    if (!first.converged) return first;
    StandardStep both = in_two(whole, first, run(first.motion, time + dt / 2, dt / 2, left - 1), dt / 2);
    ++both.halvings;
    return both;
  }

  const StandardScene& scene_;
  double whole_;
};

StandardStep parted_at_impacts(const Halves& halves, const Motion& start, double time, double dt, double instant,
                               int impacts_left) {
  StandardStep whole = halves.run(start, time, dt);
  const double left = whole.struck - instant;
  const bool are_few = whole.touches.size() <= FrictionalProblem::kFewPairs;
  if (!whole.converged || !are_few || impacts_left == 0 || left < instant) return whole;
  const StandardStep first = halves.run(start, time, dt - left);
  whole.solves += first.solves;
  if (!first.converged) return whole;
  StandardStep second = parted_at_impacts(halves, first.motion, time + dt - left, left, instant, impacts_left - 1);
  if (!second.converged) return whole;
  whole.solves -= first.solves;
  StandardStep both = in_two(whole, first, std::move(second), left);
  if (both.halvings == 0) both.least = whole.least;  // an impact does not change the step size that was needed
  return both;
}

}  // namespace

StandardStep standard_step(const StandardScene& scene, const Motion& start, double time, double dt) {
  return parted_at_impacts(Halves(scene, dt), start, time, dt, of_steps::kInstant * dt, of_steps::kMostImpacts);
}

}  // namespace keyblock
