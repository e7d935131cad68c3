// Modes from the rigid motions of bodies; see rigid_covers.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/rigid_covers.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace keyblock {
namespace {

// A support that resists a rigid motion by more than this share of the stiffest holds it.
constexpr double kHolds = 1e-9;

}  // namespace

RigidCovers::RigidCovers(const ElasticBodies& bodies, const Eigen::VectorXd& d)
    : functions_(bodies.rigid.functions()),
      size_(bodies.unknown_count()),
      body_of_(static_cast<std::size_t>(size_ / 2), -1),
      rows_(body_of_.size()) {
  const std::vector<RigidMotion> motions = bodies.rigid.motions(d, Eigen::VectorXd::Zero(size_));
  for (std::size_t b = 0; b < motions.size(); ++b) {
    for (std::size_t i = 0; i < functions_[b].size(); ++i) {
      const auto function = static_cast<std::size_t>(functions_[b][i]);
      body_of_[function] = static_cast<int>(b);
      rows_[function] = static_cast<Eigen::Index>(2 * i);
    }
    const Eigen::Vector3d root(1 / std::sqrt(motions[b].mass), 1 / std::sqrt(motions[b].mass),
                               1 / std::sqrt(motions[b].rotary_inertia));
    modes_.push_back(bodies.rigid.modes(static_cast<int>(b), d, motions[b].centre) * root.asDiagonal());
    inverse_.push_back(free_first(bodies, b));
  }
}

// Turns the modes of a body to those that no support of the problem resists, and the held ones after them.
Eigen::Matrix3d RigidCovers::free_first(const ElasticBodies& bodies, std::size_t b) {
  Eigen::MatrixX3d all = Eigen::MatrixX3d::Zero(size_, 3);
  for (std::size_t i = 0; i < functions_[b].size(); ++i)
    all.middleRows<2>(2 * functions_[b][i]) = modes_[b].middleRows<2>(static_cast<Eigen::Index>(2 * i));
  Eigen::Matrix3d held;
  for (Eigen::Index c = 0; c < 3; ++c) held.col(c) = all.transpose() * bodies.supports.times(all.col(c));
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> directions((held + held.transpose()) / 2);
  modes_[b] *= directions.eigenvectors();
  const Eigen::Vector3d resistance = directions.eigenvalues();  // ascending
  return (resistance.array() <= kHolds * resistance.cwiseAbs().maxCoeff()).cast<double>().matrix().asDiagonal();
}

Eigen::Vector3d RigidCovers::project(int body, std::span<const CoverEntry> entries) const {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  const Eigen::MatrixX3d& modes = modes_[static_cast<std::size_t>(body)];
  for (const CoverEntry& entry : entries) {
    const auto function = static_cast<std::size_t>(entry.function);
    if (body_of_[function] != body) continue;
    sum += entry.x * modes.row(rows_[function]).transpose() + entry.y * modes.row(rows_[function] + 1).transpose();
  }
  return sum;
}

void RigidCovers::add(int body, const Eigen::Vector3d& motion, Eigen::VectorXd& unknowns) const {
  const auto b = static_cast<std::size_t>(body);
  const Eigen::VectorXd own = modes_[b] * motion;
  for (std::size_t i = 0; i < functions_[b].size(); ++i)
    unknowns.segment<2>(2 * functions_[b][i]) += own.segment<2>(static_cast<Eigen::Index>(2 * i));
}

Eigen::VectorXd RigidCovers::velocity(const Eigen::VectorXd& momentum) const {
  Eigen::VectorXd velocity = Eigen::VectorXd::Zero(size_);
  for (std::size_t b = 0; b < modes_.size(); ++b)
    add(static_cast<int>(b), inverse_[b] * (modes_[b].transpose() * unknowns_of(functions_[b], momentum)), velocity);
  return velocity;
}

}  // namespace keyblock
