// Factorises a large symmetric matrix by Cholesky's method while its pattern stays and its values change, as between
// Newton iterations.
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
/// added to its diagonal, and refinement removes this again (Strouboulis, Babuška & Copps 2000). The undetermined
/// remainder is a combination of unknowns without displacement. Of two threads that solve at once one waits.
class SparseFactor : public LinearFactor {
 public:
  /// Orders and analyses the pattern of a lower triangle, whose diagonals come first in their columns; the values do
  /// not matter.
  SparseFactor(const Eigen::SparseMatrix<double>& lower, Definiteness definiteness);
  ~SparseFactor() override;
  SparseFactor(SparseFactor&&) noexcept;
  SparseFactor& operator=(SparseFactor&&) noexcept;

  /// Factorises values on that pattern. Throws NotPositiveDefinite.
  void factorise(const Eigen::SparseMatrix<double>& lower) override;

  /// Returns A⁻¹ `right`, column by column; refined if the matrix is semidefinite.
  Eigen::MatrixXd solve(const Eigen::MatrixXd& right) const override;
  Eigen::MatrixXd solve_transposed(const Eigen::MatrixXd& right) const override { return solve(right); }

  struct Refined {
    Eigen::VectorXd x;
    int refinements = 0;
  };
  /// Returns A⁻¹ `right`, refined until the residual no longer falls.
  Refined solve_refined(const Eigen::VectorXd& right) const;

  /// Returns the number of entries of L.
  double entries() const override;

 private:
  struct Cholmod;
  std::unique_ptr<Cholmod> cholmod_;
};

}  // namespace keyblock
