// Wraps Eigen's factorisation in the common interface.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/sparse_lu.hpp"

#include <Eigen/SparseLU>

namespace keyblock {

struct SparseLu::Eigens {
  Eigen::SparseLU<Eigen::SparseMatrix<double>, Eigen::COLAMDOrdering<int>> factor;
};

SparseLu::SparseLu(const Eigen::SparseMatrix<double>& matrix) : eigens_(std::make_unique<Eigens>()) {
  eigens_->factor.analyzePattern(matrix);
}

SparseLu::~SparseLu() = default;
SparseLu::SparseLu(SparseLu&&) noexcept = default;
SparseLu& SparseLu::operator=(SparseLu&&) noexcept = default;

void SparseLu::factorise(const Eigen::SparseMatrix<double>& matrix) {
  eigens_->factor.factorize(matrix);
  if (eigens_->factor.info() != Eigen::Success) throw SingularMatrix("the matrix is singular");
}

Eigen::MatrixXd SparseLu::solve(const Eigen::MatrixXd& right) const {
  if (right.cols() != 1) return eigens_->factor.solve(right);
  const Eigen::VectorXd one = right;  // for one column there are faster kernels
  const Eigen::VectorXd x = eigens_->factor.solve(one);
  return x;
}

Eigen::MatrixXd SparseLu::solve_transposed(const Eigen::MatrixXd& right) const {
  return eigens_->factor.transpose().solve(right);
}

double SparseLu::entries() const {
  return static_cast<double>(eigens_->factor.nnzL()) + static_cast<double>(eigens_->factor.nnzU());
}

}  // namespace keyblock
