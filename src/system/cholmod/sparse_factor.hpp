// The Cholesky factor of a large symmetric matrix whose values change while its pattern stays, as from round to round
// of Newton's method.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <stdexcept>

#include "system/linear_factor.hpp"

namespace keyblock {

/// The factorisation met a pivot that is not positive.
class NotPositiveDefinite : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

enum class Definiteness {
  definite,
  semidefinite,  ///< unknowns may depend on each other; the load lies in the range of the matrix
};

/// Supernodal L Lᵀ (CHOLMOD) of the matrix scaled to a diagonal of ones. A semidefinite matrix is factorised with 1e-11
/// added to its diagonal; refinement takes that out again (Strouboulis, Babuška & Copps 2000): what it leaves
/// undetermined is a combination of unknowns that makes no displacement. Of two threads that solve at once one waits.
class SparseFactor : public LinearFactor {
 public:
  /// Orders and analyses the pattern of a lower triangle, whose diagonals open their columns; the values do not matter.
  SparseFactor(const Eigen::SparseMatrix<double>& lower, Definiteness definiteness);
  ~SparseFactor() override;
  SparseFactor(SparseFactor&&) noexcept;
  SparseFactor& operator=(SparseFactor&&) noexcept;

  /// Of values on that pattern. Throws NotPositiveDefinite.
  void factorise(const Eigen::SparseMatrix<double>& lower) override;

  /// A⁻¹ `right`, column by column; refined where the matrix is semidefinite.
  Eigen::MatrixXd solve(const Eigen::MatrixXd& right) const override;
  Eigen::MatrixXd solve_transposed(const Eigen::MatrixXd& right) const override { return solve(right); }

  struct Refined {
    Eigen::VectorXd x;
    int refinements = 0;
  };
  /// A⁻¹ `right`, refined until the residual no longer falls.
  Refined solve_refined(const Eigen::VectorXd& right) const;

  /// Entries of L.
  double entries() const override;

 private:
  struct Cholmod;
  std::unique_ptr<Cholmod> cholmod_;
};

}  // namespace keyblock
