// Collects the free motion group by group.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/time/free_motion.hpp"

#include "base/worse.hpp"

namespace keyblock {

FreeMotion::FreeMotion(const StandardScene& scene, const Motion& start, const UnknownsTable& loads,
                       const StepRule& rule, double dt)
    : scene_(scene), start_(start), rule_(rule), size_(scene.size()) {
  for (const auto& group : scene.groups) {
    has_kinks_ = has_kinks_ || group->may_yield();
    if (auto estimated = group->begin(start, loads, rule, dt, step_)) estimated_.push_back(std::move(estimated));
  }
}

bool FreeMotion::linearise(const UnknownsTable& estimate) {
  bool has_factor = true;
  for (const auto& of_group : estimated_) has_factor = of_group->linearise(estimate, step_) && has_factor;
  return has_factor;
}

void FreeMotion::evaluate(const UnknownsTable& estimate) {
  for (const auto& of_group : estimated_) of_group->evaluate(estimate, step_);
}

UnknownsTable FreeMotion::going_on() const {
  if (!goes_on_with_acceleration()) return steady();
  UnknownsTable increments = plus(start_.a, -1, step_.known_acceleration);
  increments *= 1 / rule_.end_acceleration.increment;
  return increments;
}

UnknownsTable FreeMotion::steady() const {
  UnknownsTable increments = plus(start_.v, -1, step_.known_velocity);
  increments *= 1 / rate();
  return increments;
}

BodiesMotion FreeMotion::end(const UnknownsTable& increments, bool is_found) const {
  BodiesMotion end{plus(start_.q, 1, increments), plus(step_.known_velocity, rate(), increments),
                   plus(step_.known_acceleration, rule_.end_acceleration.increment, increments), start_.points};
  if (is_found)
    for (const auto& of_group : estimated_) of_group->put_end(increments, end.v, end.a, end.points);
  return end;
}

double FreeMotion::greatest_change(const UnknownsTable& a, const UnknownsTable& b) const {
  double greatest = 0;
  for (const auto& group : scene_.groups) greatest = worse(greatest, group->greatest_change(a, b));
  return greatest;
}

}  // namespace keyblock
