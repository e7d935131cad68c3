// The steps are those of dynamics, of the file's size.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/rest/relaxation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/progress/headway.hpp"
#include "base/words/plain_number.hpp"
#include "step/newton/tolerances.hpp"
#include "step/scene/acceleration.hpp"
#include "step/scene/equilibrium.hpp"
#include "step/time/ledger.hpp"

namespace keyblock {
namespace {

using namespace tolerances;

void freeze(TimeCurve& curve, double time) {
  curve = {{time}, {curve.at(time)}, curve.place};
}

// Loads and held points as they are at `time`, whatever the time of a step.
StandardScene frozen(StandardScene scene, double time) {
  for (CarriedPoint& point : scene.held) freeze(point.curve, time);
  for (CarriedPoint& point : scene.model.loading_points) freeze(point.curve, time);
  freeze(scene.settings.body_acceleration.curve, time);
  return scene;
}

class Relaxation {
 public:
  Relaxation(const StandardScene& scene, const Motion& start, double time)
      : scene_(frozen(scene, time)),
        start_(start),
        time_(time),
        driving_(driving_force(scene_, start, time, scene.settings.time_step)) {
    result_.motion = start;
    stop();
  }

  StandardStep run() {
    for (int step = 0; step < of_relaxation::kMostSteps && result_.converged && result_.failure.empty(); ++step) {
      if (is_at_rest()) return std::move(result_);
      make_step();
    }
    if (result_.converged && result_.failure.empty()) give_up();
    return std::move(result_);
  }

 private:
  bool is_at_rest() {
    if (kinetic_ > of_relaxation::kAtRest * std::max(work_, greatest_kinetic_)) return false;
    const Balance balance = balance_of(scene_, result_.motion, time_, driving_);
    result_.residual = balance.share;
    way_ = std::max(way_, share_of_fall(1, balance.share, of_relaxation::kBalancedAsARule));  // it swings
    tell_headway("dynamic relaxation", way_);
    const bool is_enough = balance.holds() || is_near_enough(balance);
    if (is_enough) stop();
    return is_enough;
  }

  bool is_near_enough(const Balance& balance) const {
    return steps_ > of_relaxation::kPatience && balance.holds_points && balance.share <= of_statics::kBalanceAcceptable;
  }

  // What is not at rest where it is: a cycle of contacts, or a motion too slow to go anywhere.
  void give_up() {
    const Balance balance = balance_of(scene_, result_.motion, time_, driving_);
    result_.residual = balance.share;
    result_.restless = balance.blocks;
    result_.failure = fmt::format("dynamic relaxation comes to no rest in {} steps", steps_);
    result_.failure += balance.blocks.empty() ? std::string("; held points are not yet where they are driven to")
                                              : fmt::format(": {} moves to and fro, {:.1e} of the load out of balance",
                                                            in_words(scene_, balance.blocks), balance.share);
  }

  // Of those that went away the one that came farthest, over its size.
  void give_up_on(const Travel& travel) {
    result_.moving = travel.far;
    const auto before = vertices_at(scene_.model, scene_.reference, start_.q);
    const auto after = vertices_at(scene_.model, scene_.reference, result_.motion.q);
    double farthest = 0;
    Point way;
    ElementIndex gone = travel.far.front();
    for (const ElementIndex e : travel.far)
      for (const VertexIndex v : scene_.model.elements[e].vertices()) {
        const double share = distance(before[v], after[v]) / scene_.bodies()[e].size;
        if (share <= farthest) continue;
        farthest = share;
        way = after[v] - before[v];
        gone = e;
      }
    result_.failure = fmt::format(
        "{}; dynamic relaxation followed it for {} steps: {} has gone {:.3g} times its size, by ({}, {}), "
        "and comes to no rest near where it was",
        no_equilibrium(scene_, travel.far), steps_, part_name(scene_, gone), farthest, plain(way.x, 3),
        plain(way.y, 3));
  }

  void make_step() {
    ++steps_;
    const UnknownsTable from = result_.motion.q;
    StandardStep made = standard_step(scene_, result_.motion, time_, scene_.settings.time_step);
    made.solves += result_.solves;
    made.fallbacks += result_.fallbacks;
    made.halvings += result_.halvings;
    made.locked_overlaps += result_.locked_overlaps;
    result_ = std::move(made);
    if (!result_.converged) return;
    add_work(from);
    const double last = kinetic_;
    kinetic_ = kinetic_energy(scene_, result_.motion.v);
    greatest_kinetic_ = std::max(greatest_kinetic_, kinetic_);
    const Travel travel = travel_of(scene_, start_.q, result_.motion.q);
    if (!travel.far.empty()) give_up_on(travel);
    if (kinetic_ < last) stop();
  }

  void stop() {
    result_.motion.v.set_zero();
    result_.motion.a = balanced_acceleration(scene_, result_.motion, time_);
    kinetic_ = 0;
  }

  void add_work(const UnknownsTable& from) {
    const UnknownsTable loads = loads_at(scene_, from, time_);
    work_ += std::abs(dot(loads, plus(result_.motion.q, -1, from)));
  }

  StandardScene scene_;
  const Motion& start_;
  double time_;
  double driving_;  ///< force
  int steps_ = 0;
  double way_ = 0;  ///< share of the way to balance, as told
  double work_ = 0;
  double kinetic_ = 0;
  double greatest_kinetic_ = 0;
  StandardStep result_;
};

}  // namespace

StandardStep relaxation_step(const StandardScene& scene, const Motion& start, double time) {
  return Relaxation(scene, start, time).run();
}

}  // namespace keyblock
