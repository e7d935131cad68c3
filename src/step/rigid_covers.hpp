// Bodies on covers as rigid ones: their modes, and how these answer to forces.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "contact/contact_row.hpp"
#include "step/elastic_bodies.hpp"
#include "system/part_factors.hpp"

namespace keyblock {

/// A body has three modes of unit mass, made of two translations and the turn about its mass centre; those that supports of the
/// problem hold come last and do not answer.
class RigidCovers {
 public:
  /// At d. The bodies must outlive it.
  RigidCovers(const ElasticBodies& bodies, const Eigen::VectorXd& d);

  /// Unknowns of all covers.
  Eigen::Index size() const { return size_; }
  /// Of the modes of each body: one where a mode is free, else zero.
  const std::vector<Eigen::Matrix3d>& inverse() const { return inverse_; }
  /// Of entries of a row, those of one body on its modes.
  Eigen::Vector3d project(int body, std::span<const CoverEntry> entries) const;
  /// Adds a motion of one body, by its modes, to the unknowns of covers.
  void add(int body, const Eigen::Vector3d& motion, Eigen::VectorXd& unknowns) const;
  /// The rigid velocities of these momenta, as unknowns of covers.
  Eigen::VectorXd velocity(const Eigen::VectorXd& momentum) const;

 private:
  Eigen::Matrix3d free_first(const ElasticBodies& bodies, std::size_t b);

  const std::vector<std::vector<int>>& functions_;
  Eigen::Index size_;
  std::vector<int> body_of_;        ///< of each function
  std::vector<Eigen::Index> rows_;  ///< of each function among the modes of its body
  std::vector<Eigen::MatrixX3d> modes_;
  std::vector<Eigen::Matrix3d> inverse_;
};

}  // namespace keyblock
