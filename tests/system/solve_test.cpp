// The block system is solved to its true residual; a singular one is refused.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/solve.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

namespace keyblock::solve_test {
namespace {

System random_chain(int count) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> value(-1, 1);
  System system(std::vector<int>(static_cast<std::size_t>(count), 6));
  for (int i = 0; i < count; ++i) {
    system.matrix.add(i, i, 20 * BlockMatrix::Block::Identity(6, 6));
    if (i == 0) continue;
    BlockMatrix::Block coupling(6, 6);
    for (double& x : coupling.reshaped()) x = value(random);
    system.matrix.add(i, i / 2, coupling);
  }
  for (double& x : system.load) x = value(random);
  return system;
}

Eigen::MatrixXd dense(const BlockMatrix& matrix) {
  Eigen::MatrixXd full(matrix.row_count(), matrix.row_count());
  for (int column = 0; column < matrix.row_count(); ++column)
    full.col(column) = matrix * Eigen::VectorXd::Unit(matrix.row_count(), column);
  return full;
}

}  // namespace

TEST(Solve, agrees_with_a_dense_solution) {
  const System system = random_chain(9);
  const auto solution = Solver().solve(system);
  ASSERT_TRUE(solution);
  const Eigen::VectorXd expected = dense(system.matrix).fullPivLu().solve(system.load);
  EXPECT_LT((solution->x - expected).norm(), 1e-13 * expected.norm());
  EXPECT_LT(solution->residual, 1e-14);
}

TEST(Solve, pattern_may_change_between_solves) {
  Solver solver;
  ASSERT_TRUE(solver.solve(random_chain(9)));
  const System other = random_chain(12);
  const auto solution = solver.solve(other);
  ASSERT_TRUE(solution);
  EXPECT_LT((other.load - other.matrix * solution->x).norm(), 1e-13 * other.load.norm());
}

TEST(Solve, singular_system_is_refused) {
  System system({6});
  system.load.setOnes();
  EXPECT_FALSE(Solver().solve(system));
}

TEST(Solve, system_with_nan_is_refused) {
  System system = random_chain(3);
  system.load[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(Solver().solve(system));
}

}  // namespace keyblock::solve_test
