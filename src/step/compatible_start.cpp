// Three rounds of force, strain and shift: each sees the geometry the last one left.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/compatible_start.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>

#include "contact/frictional_problem.hpp"
#include "contact/gap.hpp"

namespace keyblock {
namespace {

constexpr int kRounds = 3;
// Gaps below this share of block size count as closed: far above the rounding of files, far below what the eye sees.
constexpr double kTouching = 1e-6;
constexpr double kRedundant = 1e-5;  // pivots of scaled W below this share of the largest are taken as zero
// A block that shifts by more than this times all gaps together is thrown about, not settled.
constexpr double kLeverage = 10;
constexpr double kForceTolerance = 1e-12;  // of the largest force on a block
constexpr double kLooser = 1e6;            // what counts as solved where the goal is out of reach

class Settling {
 public:
  Settling(const StandardScene& scene, Motion motion)
      : scene_(scene),
        motion_(std::move(motion)),
        loads_(loads_at(scene, motion_.q, 0)),
        rigid_(every(scene.bodies, &Body::rigid_mass_inverse)) {
    const Scales scales = scales_of(scene_, loads_, motion_.v);
    tolerance_ = kForceTolerance * scales.force;
    touches_ = resting(touches_of(scene_, motion_, scales, scene_.settings.time_step), scales);
  }

  CompatibleStart run() {
    if (tolerance_ == 0) return {std::move(motion_), {}};
    for (int round = 0; round < kRounds; ++round) {
      rows_ = contact_rows(scene_.model, scene_.reference, motion_.q, touches_);
      find_forces();
      strain();
      shift();
    }
    remember();
    const std::string failure = greatest_shift_ > kLeverage * asked_ ? too_far() : std::string();
    return {std::move(motion_), failure};
  }

 private:
  Touches resting(const Touches& all, const Scales& scales) const {
    const double slow = slow_speed(scales, motion_.v, scene_.settings.time_step);
    const Eigen::VectorXd speeds = rates(contact_rows(scene_.model, scene_.reference, motion_.q, all), motion_.v);
    const auto vertices = vertices_at(scene_.model, scene_.reference, motion_.q);
    Touches touches;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const bool touching = std::abs(gap_of(all[i], vertices)) < kTouching * scales.size;
      if (touching && std::abs(speeds[static_cast<Eigen::Index>(2 * i)]) <= slow) touches.push_back(all[i]);
    }
    return touches;
  }

  // Velocities after one step of free acceleration stand for g̈, so that a block that slides already keeps its direction.
  void find_forces() {
    const double dt = scene_.settings.time_step;
    forces_ = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(rows_.size()));
    if (!touches_.empty()) {
      FrictionalProblem problem{dt * contact_matrix(rows_, rigid_), dt * rates(rows_, product(rigid_, loads_)),
                                friction_of(scene_, touches_), tolerance_, kLooser * tolerance_};
      const Eigen::VectorXd v = rates(rows_, motion_.v);
      for (Eigen::Index t = 1; t < v.size(); t += 2) problem.b[t] += v[t];
      forces_ = solve(problem, forces_).forces;
    }
    acceleration_ = plus(product(rigid_, loads_), 1, answer(rows_, rigid_, forces_));
  }

  void strain() {
    UnknownsTable forces = plus(loads_, 1, answer(rows_, identities(), forces_));
    for (ElementIndex e : indices(forces)) {
      const Body& body = scene_.bodies[e];
      const Eigen::Index strains = body.mass.rows() - kRigidUnknowns;
      if (strains <= 0) continue;
      forces[e] += body.initial_stress - body.mass * acceleration_[e];
      const Eigen::MatrixXd stiffness = body.stiffness.bottomRightCorner(strains, strains);
      motion_.q[e].tail(strains) = stiffness.inverse() * forces[e].tail(strains);
    }
  }

  void shift() {
    ContactRows normals;
    std::vector<double> missing;
    const auto vertices = vertices_at(scene_.model, scene_.reference, motion_.q);
    for (std::size_t i = 0; i < touches_.size(); ++i) {
      const double force = normal(i);
      if (force <= 0) continue;
      normals.push_back(rows_[2 * i]);
      const double wanted = scene_.has_springs() ? -force / scene_.normal_stiffness() : 0;
      missing.push_back(wanted - gap_of(touches_[i], vertices));
    }
    if (missing.empty()) return;
    const Eigen::Map<const Eigen::VectorXd> right(missing.data(), static_cast<Eigen::Index>(missing.size()));
    const UnknownsTable by = answer(normals, rigid_, least_push(contact_matrix(normals, rigid_), right));
    motion_.q = plus(motion_.q, 1, by);
    asked_ += right.cwiseAbs().sum();
    for (ElementIndex e : indices(by))
      if (by[e].size() > 0) greatest_shift_ = std::max(greatest_shift_, by[e].head<2>().norm());
  }

  // W is scaled to a unit diagonal, so that heavy blocks count as light ones. Blocks wedged among blocks make it all but
  // singular: combinations of pushes that would close a gap by a large shift only are left to the elastic contact.
  static Eigen::VectorXd least_push(const Eigen::MatrixXd& w, const Eigen::VectorXd& right) {
    const Eigen::VectorXd scale = w.diagonal().cwiseSqrt().cwiseInverse();
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> inverse;
    inverse.setThreshold(kRedundant);
    inverse.compute(scale.asDiagonal() * w * scale.asDiagonal());
    return scale.asDiagonal() * inverse.solve(scale.asDiagonal() * right);
  }

  std::string too_far() const {
    return fmt::format(
        "no compatible start was found: blocks would have to shift by {:.3g} to close gaps of {:.3g} in all; choose "
        "start = "
        "sudden",
        greatest_shift_, asked_);
  }

  void remember() {
    for (std::size_t i = 0; i < touches_.size(); ++i) {
      if (normal(i) <= 0) continue;
      const double tangential = forces_[static_cast<Eigen::Index>(2 * i + 1)];
      motion_.closed[touches_[i]] = {normal(i), tangential, -tangential / scene_.tangential_stiffness()};
    }
  }

  double normal(std::size_t touch) const { return forces_[static_cast<Eigen::Index>(2 * touch)]; }

  Table<ElementIndex, UnknownBlock> identities() const {
    Table<ElementIndex, UnknownBlock> all = rigid_;
    for (UnknownBlock& block : all) block.setIdentity();
    return all;
  }
  static UnknownsTable product(const Table<ElementIndex, UnknownBlock>& blocks, const UnknownsTable& x) {
    UnknownsTable result = x;
    for (ElementIndex e : indices(x)) result[e] = blocks[e] * x[e];
    return result;
  }

  const StandardScene& scene_;
  Motion motion_;
  UnknownsTable loads_;
  Table<ElementIndex, UnknownBlock> rigid_;
  Touches touches_;
  double tolerance_ = 0;
  ContactRows rows_;
  Eigen::VectorXd forces_;
  UnknownsTable acceleration_;
  double asked_ = 0;           ///< sum of all gaps that shifts were to close
  double greatest_shift_ = 0;  ///< of one block in one round
};

}  // namespace

CompatibleStart compatible(const StandardScene& scene, Motion motion) {
  return Settling(scene, std::move(motion)).run();
}

}  // namespace keyblock
