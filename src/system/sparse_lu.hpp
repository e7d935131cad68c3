// Factorises a large matrix that is not symmetric: of friction, or of non-associated flow.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <stdexcept>

#include "system/linear_factor.hpp"

namespace keyblock {

/// A matrix without an inverse, or with none that double precision finds.
class SingularMatrix : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Supernodal L U with partial pivoting (Eigen's SparseLU, after SuperLU: Demmel et al. 1999), columns by COLAMD.
class SparseLu : public LinearFactor {
 public:
  /// Orders and analyses the pattern of a whole matrix, compressed; the values do not matter.
  explicit SparseLu(const Eigen::SparseMatrix<double>& matrix);
  ~SparseLu() override;
  SparseLu(SparseLu&&) noexcept;
  SparseLu& operator=(SparseLu&&) noexcept;

  /// Factorises values on that pattern. Throws SingularMatrix.
  void factorise(const Eigen::SparseMatrix<double>& matrix) override;
  Eigen::MatrixXd solve(const Eigen::MatrixXd& right) const override;
  Eigen::MatrixXd solve_transposed(const Eigen::MatrixXd& right) const override;
  double entries() const override;

 private:
  struct Eigens;
  std::unique_ptr<Eigens> eigens_;
};

}  // namespace keyblock
