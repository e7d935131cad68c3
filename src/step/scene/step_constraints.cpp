// Numbers the constraints: bolts first, then points. Broken bolts, and bolts whose force is a load, are left out.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/scene/step_constraints.hpp"

#include <algorithm>

namespace keyblock {
namespace {

// Above this fraction of its strength a bolt has reached it: residuals of the forces are smaller.
constexpr double kAtStrength = 1 - 1e-9;

Eigen::Index pair(std::size_t i) {
  return static_cast<Eigen::Index>(2 * i);
}

}  // namespace

StepConstraints::StepConstraints(const StandardScene& scene, const Motion& start, double time, double dt, double weight)
    : scene_(scene), start_(start), points_(scene.held), end_time_(time + dt), weight_(weight) {
  for (std::size_t i = 0; i < scene.model.bolts.size(); ++i)
    if (scene.model.bolts[i].is_spring() && !start.constraints.broken[i]) bolts_.push_back(i);
}

Eigen::VectorXd StepConstraints::remembered() const {
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(pair(count()));
  for (std::size_t i = 0; i < bolts_.size(); ++i) forces[pair(i)] = -start_.constraints.bolt_forces[bolts_[i]];
  forces.tail(start_.constraints.point_forces.size()) = start_.constraints.point_forces;
  return forces;
}

ContactRows StepConstraints::rows(const UnknownsTable& q) const {
  ContactRows rows;
  if (!bolts_.empty()) {
    const ContactRows all = bolt_rows(scene_.model, scene_.reference, q);
    for (std::size_t bolt : bolts_) {
      rows.push_back(all[2 * bolt]);
      rows.push_back(all[2 * bolt + 1]);
    }
  }
  if (points_.empty()) return rows;
  const ContactRows of_points = point_rows(scene_.model, scene_.reference, q, points_);
  rows.insert(rows.end(), of_points.begin(), of_points.end());
  return rows;
}

double StepConstraints::compliance(std::size_t constraint) const {
  return constraint < bolts_.size() ? 1 / (weight_ * scene_.model.bolts[bolts_[constraint]].stiffness) : 0;
}

ForceLaw StepConstraints::law(std::size_t constraint) const {
  return constraint < bolts_.size() ? ForceLaw{0, 0, -scene_.model.bolts[bolts_[constraint]].strength} : kHeld;
}

Eigen::VectorXd StepConstraints::gaps(const UnknownsTable& q) const {
  Eigen::VectorXd gaps = Eigen::VectorXd::Zero(pair(count()));
  const Eigen::VectorXd longer = elongation(q);
  for (std::size_t i = 0; i < bolts_.size(); ++i) {
    const Bolt& bolt = scene_.model.bolts[bolts_[i]];
    const double at_start = start_.constraints.bolt_forces[bolts_[i]] / bolt.stiffness;
    gaps[pair(i)] =
        longer[static_cast<Eigen::Index>(i)] + bolt.pretension / bolt.stiffness + (1 / weight_ - 1) * at_start;
  }
  if (!points_.empty())
    gaps.tail(pair(points_.size())) = offsets(scene_.model, scene_.reference, q, points_, end_time_);
  return gaps;
}

Eigen::VectorXd StepConstraints::elongation(const UnknownsTable& q) const {
  Eigen::VectorXd longer(static_cast<Eigen::Index>(bolts_.size()));
  if (bolts_.empty()) return longer;
  const Eigen::VectorXd all = elongations(scene_.model, scene_.reference, q);
  for (std::size_t i = 0; i < bolts_.size(); ++i)
    longer[static_cast<Eigen::Index>(i)] = all[static_cast<Eigen::Index>(bolts_[i])];
  return longer;
}

double StepConstraints::at_end(std::size_t bolt, const Motion& end) const {
  const std::size_t i = bolts_[bolt];
  return end.constraints.broken[i] ? scene_.model.bolts[i].strength : end.constraints.bolt_forces[i];
}

ConstraintMemory StepConstraints::memory(const Eigen::VectorXd& forces, const UnknownsTable& q) const {
  ConstraintMemory memory = start_.constraints;
  const Eigen::VectorXd longer = weight_ < 1 ? elongation(q) : Eigen::VectorXd();
  for (std::size_t i = 0; i < bolts_.size(); ++i) {
    const Bolt& bolt = scene_.model.bolts[bolts_[i]];
    const double over_step = -forces[pair(i)];
    const double at_end =
        weight_ < 1 ? bolt.pretension + bolt.stiffness * longer[static_cast<Eigen::Index>(i)] : over_step;
    memory.broken[bolts_[i]] = std::max(over_step, at_end) >= kAtStrength * bolt.strength;
    memory.bolt_forces[bolts_[i]] = memory.broken[bolts_[i]] ? 0 : at_end;
  }
  memory.point_forces = forces.tail(pair(points_.size()));
  return memory;
}

void put_bolt_forces(const StandardScene& scene, Motion& motion) {
  const Eigen::VectorXd longer = elongations(scene.model, scene.reference, motion.q);
  for (std::size_t i = 0; i < scene.model.bolts.size(); ++i) {
    const Bolt& bolt = scene.model.bolts[i];
    if (bolt.is_spring() && !motion.constraints.broken[i])
      motion.constraints.bolt_forces[i] = bolt.pretension + bolt.stiffness * longer[static_cast<Eigen::Index>(i)];
  }
}

ContactRows rows_with_points(const StandardScene& scene, const UnknownsTable& q, const Touches& touches) {
  ContactRows rows = contact_rows(scene.model, scene.reference, q, touches);
  if (scene.held.empty()) return rows;
  const ContactRows of_points = point_rows(scene.model, scene.reference, q, scene.held);
  rows.insert(rows.end(), of_points.begin(), of_points.end());
  return rows;
}

}  // namespace keyblock
