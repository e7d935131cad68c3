// The forces of an active set by their own equations: a body on covers couples all forces on it, and no others.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/SparseLU>

#include "contact/solve/active_forces.hpp"

namespace keyblock {

/// (R W F + R D F) u = f (forces_of_blocks.hpp), R the rows kept, F the columns, D what stands on the diagonal besides,
/// which may be 0 here. Sparse where the scene has many bodies.
class CoupledForces {
 public:
  CoupledForces(const ContactMatrix& w, const ActiveSet& set, const Eigen::VectorXd& added);

  bool is_regular() const { return factor_.info() == Eigen::Success; }
  /// u for one f, an entry an unknown each.
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const { return factor_.solve(right); }

 private:
  Eigen::SparseLU<Eigen::SparseMatrix<double>, Eigen::COLAMDOrdering<int>> factor_;
};

}  // namespace keyblock
