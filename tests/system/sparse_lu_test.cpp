// Matrices that are not symmetric compared with dense algebra; the same factorisation solves the transposed.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/sparse_lu.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <memory>
#include <random>

#include "system/cholmod/sparse_factor.hpp"

namespace keyblock::sparse_lu_test {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

/// A band with entries off it, strong on the diagonal if `is_strong`, else with zeros there.
Sparse scattered(int size, unsigned seed, bool is_strong) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> value(-1, 1);
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(size, size);
  for (int i = 0; i < size; ++i) {
    dense(i, i) = is_strong ? 4 : 0;
    dense(i, (i + 1) % size) = 1 + value(random);
    dense((i + 3) % size, i) = value(random);
    dense(i, (7 * i + 2) % size) += value(random);
  }
  return dense.sparseView();
}

}  // namespace

TEST(SparseLu, solves_the_matrix_and_its_transposed) {
  for (const bool is_strong : {true, false}) {
    const Sparse a = scattered(40, 3, is_strong);
    SparseLu factor(a);
    factor.factorise(a);
    const Eigen::MatrixXd right = Eigen::MatrixXd::Random(40, 3);
    const Eigen::MatrixXd dense(a);
    const double condition = dense.norm() * dense.inverse().norm();
    EXPECT_LT((dense * factor.solve(right) - right).norm(), 1e-15 * condition * right.norm());
    EXPECT_LT((dense.transpose() * factor.solve_transposed(right) - right).norm(), 1e-15 * condition * right.norm());
    EXPECT_GT(factor.entries(), 40);
  }
}

TEST(SparseLu, other_values_on_the_same_pattern_are_factorised_again) {
  Sparse a = scattered(20, 5, true);
  SparseLu factor(a);
  factor.factorise(a);
  a *= 3;
  a.coeffRef(0, 0) = 11;
  factor.factorise(a);
  const Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(20, 1, 2);
  EXPECT_LT((a * factor.solve(right) - right).norm(), 1e-13);
}

TEST(SparseLu, a_matrix_without_an_inverse_is_named) {
  Eigen::Matrix3d dense;
  dense << 1, 2, 3, 2, 4, 6, 1, 0, 1;
  const Sparse a = dense.sparseView();
  SparseLu factor(a);
  EXPECT_THROW(factor.factorise(a), SingularMatrix);
}

// A caller need not know the kind of the factorisation.
TEST(SparseLu, answers_as_the_factor_of_a_symmetric_matrix_does) {
  const Eigen::MatrixXd half(scattered(30, 9, true));
  const Sparse whole = Eigen::MatrixXd(half * half.transpose() + Eigen::MatrixXd::Identity(30, 30)).sparseView();
  const Sparse lower = whole.triangularView<Eigen::Lower>();
  const Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(30, -1, 1);
  std::unique_ptr<LinearFactor> lu = std::make_unique<SparseLu>(whole);
  std::unique_ptr<LinearFactor> cholesky = std::make_unique<SparseFactor>(lower, Definiteness::definite);
  lu->factorise(whole);
  cholesky->factorise(lower);
  const Eigen::MatrixXd expected = whole.toDense().inverse() * right;
  for (const LinearFactor* factor : {lu.get(), cholesky.get()}) {
    EXPECT_LT((factor->solve(right) - expected).norm(), 1e-12 * expected.norm());
    EXPECT_LT((factor->solve_transposed(right) - expected).norm(), 1e-12 * expected.norm());
  }
}

}  // namespace keyblock::sparse_lu_test
