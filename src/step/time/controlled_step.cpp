// Loops over the parts of a step; the two rules differ in their judgement of a part and in the next size.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/time/controlled_step.hpp"

#include <algorithm>
#include <cmath>

#include "base/worse.hpp"
#include "step/bodies/integrator.hpp"
#include "step/newton/tolerances.hpp"
#include "step/time/step_size.hpp"

namespace keyblock {
namespace {

using namespace tolerances;

struct Verdict {
  bool accepted = true;
  double next = 0;  ///< size of the next part, or of this one when repeated
};

double relative_error(const StandardScene& scene, const Motion& before, const Motion& after, double dt) {
  const StepRule rule = step_rule(scene.settings, dt);
  double greatest = 0;
  for (const auto& group : scene.groups) greatest = worse(greatest, group->step_error(before, after, rule, dt));
  return greatest;
}

Verdict by_error(const StandardScene& scene, const Motion& before, const Motion& after, double dt) {
  if (!after.q.all_finite() || !after.v.all_finite() || !after.a.all_finite())
    return {false, of_step_control::kMostCut * dt};
  const double share = relative_error(scene, before, after, dt) / scene.settings.standard.step_tolerance;
  const double wanted = of_step_control::kSafety * std::pow(share, -1 / of_step_control::kOrder);
  return {share <= 1, dt * std::clamp(wanted, of_step_control::kMostCut, of_step_control::kMostGrowth)};
}

State state_at(double time) {
  State state;
  state.time = time;
  return state;
}

Verdict by_displacement(const StandardScene& scene, double displacement, double time, double dt) {
  if (!std::isfinite(displacement)) return {false, of_step_control::kMostCut * dt};
  const double ratio = displacement / (scene.settings.allowed_displacement_ratio * scene.model.scale);
  if (!(ratio <= of_step_control::kGreatestRatio)) return {false, dt / std::sqrt(ratio)};
  return {true, next_step_size(scene.model, state_at(time + dt), scene.settings, {dt, ratio, 0, 0})};
}

double first_size(const StandardScene& scene, const Motion& start, double time, double interval) {
  if (scene.settings.step_control != StepControl::shi) return interval;
  double speed = 0;
  for (const Unknowns& v : start.v)
    if (v.size() > 0) speed = std::max(speed, v.head<3>().cwiseAbs().maxCoeff());
  return first_step_size(scene.model, state_at(time), scene.settings, speed);
}

class Parts {
 public:
  Parts(const StandardScene& scene, const Motion& start, double time, double interval, double first)
      : scene_(scene), time_(time), left_(interval), interval_(interval) {
    result_.next = first > 0 ? first : first_size(scene, start, time, interval);
    result_.least = interval;
    result_.step.motion = start;
  }

  ControlledStep run() {
    while (left_ > of_step_control::kEnd * interval_ && result_.step.converged && result_.step.failure.empty())
      make_part();
    return std::move(result_);
  }

 private:
  // The remainder is divided evenly, so that the last part is not tiny.
  double part() const { return left_ / std::max(1.0, std::ceil(left_ / result_.next - of_step_control::kEnd)); }

  void make_part() {
    const double least = scene_.settings.standard.least_step_share * interval_;
    const double dt = std::max(part(), std::min(least, left_));
    const bool is_least = dt <= least;
    StandardStep made = standard_step(scene_, result_.step.motion, time_, dt);
    const Verdict verdict =
        made.converged ? judged(made.motion, dt) : Verdict{false, of_step_control::kUnsolvedCut * dt};
    if (made.converged && is_least && !std::isfinite(moved(made.motion))) made.failure = {"blocks_move_without_bound"};
    made.solves += result_.step.solves;
    made.fallbacks += result_.step.fallbacks;
    made.halvings += result_.step.halvings;
    if (!verdict.accepted && !is_least) {
      result_.step.solves = made.solves;
      result_.step.fallbacks = made.fallbacks;
      result_.step.halvings = made.halvings + 1;
      result_.next = verdict.next;
      return;
    }
    if (made.converged && !verdict.accepted) ++result_.unresolved;
    made.account += result_.step.account;
    made.locked_overlaps += result_.step.locked_overlaps;
    made.keep_larger_residual(result_.step);
    if (made.converged) result_.displacement = std::max(result_.displacement, moved(made.motion));
    result_.least = std::min(result_.least, made.least);
    result_.next = verdict.next;
    result_.step = std::move(made);
    time_ += dt;
    left_ -= dt;
  }

  double moved(const Motion& after) const { return greatest_displacement(scene_, result_.step.motion.q, after.q); }

  Verdict judged(const Motion& after, double dt) const {
    return scene_.settings.step_control == StepControl::error ? by_error(scene_, result_.step.motion, after, dt)
                                                              : by_displacement(scene_, moved(after), time_, dt);
  }

  const StandardScene& scene_;
  double time_;
  double left_;
  double interval_;
  ControlledStep result_;
};

}  // namespace

double greatest_displacement(const StandardScene& scene, const UnknownsTable& from, const UnknownsTable& to) {
  const auto before = vertices_at(scene.model, scene.reference, from);
  const auto after = vertices_at(scene.model, scene.reference, to);
  double greatest = 0;
  for (VertexIndex v : indices(before)) greatest = worse(greatest, distance(before[v], after[v]));
  return greatest;
}

ControlledStep controlled_step(const StandardScene& scene, const Motion& start, double time, double interval,
                               double first) {
  return Parts(scene, start, time, interval, first).run();
}

}  // namespace keyblock
