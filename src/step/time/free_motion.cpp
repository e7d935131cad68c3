// Each block by itself, all bodies on covers together.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/time/free_motion.hpp"

#include <algorithm>
#include <utility>

#include "base/loop.hpp"
#include "base/worse.hpp"
#include "step/bodies/step_equations.hpp"

namespace keyblock {

FreeMotion::FreeMotion(const StandardScene& scene, const Motion& start, const UnknownsTable& loads,
                       const StepRule& rule, double dt)
    : scene_(scene), start_(start), rule_(rule) {
  const std::size_t count = scene.bodies.size();
  flexibility_.blocks.resize(count);
  if (rule.judging_inertia > 0) judging_.blocks.resize(count);
  for (UnknownsTable* table : {&increments_, &known_velocity_, &known_acceleration_}) table->resize(count);
  for_each_entry(count, [&](std::size_t i) { prepare({static_cast<int>(i)}, loads); });
  if (scene.covers) prepare_covers(loads.covers, dt);
  for (const Body& body : scene.bodies)
    if (body.mass.rows() > 0) size_ = std::max(size_, body.size);
  if (scene.covers) size_ = std::max(size_, scene.covers->size());
}

void FreeMotion::prepare(ElementIndex e, const UnknownsTable& loads) {
  StepEquations equations = step_equations(scene_.bodies[e], {start_.q[e], start_.v[e], start_.a[e]}, loads[e], rule_);
  flexibility_.blocks[e] = std::move(equations.inverse);
  if (!judging_.blocks.empty()) judging_.blocks[e] = std::move(equations.judging);
  increments_[e] = std::move(equations.free);
  known_velocity_[e] = std::move(equations.known_velocity);
  known_acceleration_[e] = std::move(equations.known_acceleration);
}

void FreeMotion::prepare_covers(const Eigen::VectorXd& load, double dt) {
  covers_ = &scene_.covers->equations();
  covers_->begin({start_.q.covers, start_.v.covers, start_.a.covers}, load, rule_, dt);
  known_velocity_.covers = covers_->known_velocity();
  known_acceleration_.covers = covers_->known_acceleration();
}

bool FreeMotion::linearise(const UnknownsTable& estimate) {
  if (!covers_) return true;
  bool has_factor = true;
  try {
    covers_->linearise(estimate.covers);
  } catch (const NotPositiveDefinite&) {
    has_factor = false;
  }
  flexibility_.covers = scene_.covers->flexibility_of_step();
  if (!judging_.blocks.empty()) judging_.covers = flexibility_.covers;
  return has_factor;
}

void FreeMotion::evaluate(const UnknownsTable& estimate) {
  if (!covers_) return;
  covers_->evaluate(estimate.covers);
  increments_.covers = covers_->free_increment();
}

UnknownsTable FreeMotion::steady() const {
  UnknownsTable increments = plus(start_.v, -1, known_velocity_);
  increments *= 1 / rate();
  return increments;
}

void FreeMotion::put_end(const UnknownsTable& increments, bool is_found, UnknownsTable& q, UnknownsTable& v,
                         UnknownsTable& a) const {
  q = plus(start_.q, 1, increments);
  v = plus(known_velocity_, rate(), increments);
  a = plus(known_acceleration_, rule_.end_acceleration.increment, increments);
  if (!covers_ || !is_found) return;
  CoverMotion end = covers_->end(increments.covers);
  v.covers = std::move(end.v);
  a.covers = std::move(end.a);
}

double FreeMotion::greatest_change(const UnknownsTable& a, const UnknownsTable& b) const {
  double greatest = 0;
  for (ElementIndex e : indices(a)) {
    if (a[e].size() == 0) continue;
    const Unknowns change = (a[e] - b[e]).cwiseAbs();
    greatest = worse(greatest, change.head<2>().maxCoeff<Eigen::PropagateNaN>() / scene_.bodies[e].size);
    greatest = worse(greatest, change.tail(change.size() - 2).maxCoeff<Eigen::PropagateNaN>());
  }
  if (a.covers.size() > 0)
    greatest =
        worse(greatest, (a.covers - b.covers).cwiseAbs().maxCoeff<Eigen::PropagateNaN>() / scene_.covers->size());
  return greatest;
}

}  // namespace keyblock
