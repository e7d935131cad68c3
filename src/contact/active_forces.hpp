// The linear system of contact forces when it is decided which are open, stick or slip.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/LU>
#include <Eigen/SparseLU>
#include <memory>

#include "contact/frictional_problem.hpp"

namespace keyblock {

/// Open pairs have their least normal force, slipping ones λt = ± (cohesion + μ λn): what is left are one unknown a slipping pair and
/// two a sticking one, with yn = 0 and, sticking, yt = 0. The slip makes the matrix nonsymmetric. It is factorised once
/// and serves any right side.
class ActiveForces {
 public:
  /// `added` stands on the diagonal of W beside its own entries.
  ActiveForces(const FrictionalProblem& problem, const std::vector<Grip>& grips, const Eigen::VectorXd& added);

  /// False where no factor was found: the active set leaves forces open.
  bool is_regular() const { return !sparse_ || sparse_->info() == Eigen::Success; }

  /// The forces of all pairs for y = (W + added) λ + b.
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const;

 private:
  struct Column {
    Eigen::Index unknown = -1;  ///< of the force; none if it is given
    double factor = 0;          ///< force = factor × unknown + given
    double given = 0;
  };

  void number(const std::vector<Grip>& grips);
  void assemble(const Eigen::VectorXd& added);

  const FrictionalProblem& problem_;
  std::vector<Column> columns_;     ///< of each force
  std::vector<Eigen::Index> rows_;  ///< force whose y is zero, of each unknown
  Eigen::VectorXd from_given_;      ///< W times the given forces, in the rows kept
  Eigen::PartialPivLU<Eigen::MatrixXd> dense_;
  std::unique_ptr<Eigen::SparseLU<Eigen::SparseMatrix<double>>> sparse_;
};

}  // namespace keyblock
