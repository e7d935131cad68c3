// The forces of an active set by their own equations: a body on covers couples all forces on it, and no others.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "contact/solve/active_forces.hpp"
#include "system/sparse_lu.hpp"

namespace keyblock {

/// (R W F + R D F) u = f (forces_of_blocks.hpp), R the rows kept, F the columns, D what stands on the diagonal besides,
/// which may be 0 here. Sparse where the scene has many bodies.
class CoupledForces {
 public:
  CoupledForces(const ContactMatrix& w, const ActiveSet& set, const Eigen::VectorXd& added);

  bool is_regular() const { return factor_ != nullptr; }
  /// u for one f, an entry an unknown each.
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const { return factor_->solve(right); }

 private:
  std::unique_ptr<SparseLu> factor_;  ///< none of equations that are singular
};

}  // namespace keyblock
