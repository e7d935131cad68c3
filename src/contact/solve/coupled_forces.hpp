// Solves for the forces of an active set in their own equations: an NMM body couples exactly the forces on it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "contact/solve/active_forces.hpp"
#include "system/sparse_lu.hpp"

namespace keyblock {

/// System (R W F + R D F) u = f (forces_of_blocks.hpp). R are the kept rows, F the columns, D the added diagonal, which
/// may be 0 here. The matrix is sparse if the scene has many bodies.
class CoupledForces {
 public:
  CoupledForces(const ContactMatrix& w, const ActiveSet& set, const Eigen::VectorXd& added);

  bool is_regular() const { return factor_ != nullptr; }
  /// Returns u for one f, one entry per unknown.
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const { return factor_->solve(right); }

 private:
  std::unique_ptr<SparseLu> factor_;  ///< null if the equations are singular
};

}  // namespace keyblock
