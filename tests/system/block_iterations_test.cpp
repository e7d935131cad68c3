// Iterations reach the solution of a factorisation, report if they do not, and end for a matrix that has none.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/block_iterations.hpp"

#include <gtest/gtest.h>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <random>

#include "base/context.hpp"
#include "base/loop.hpp"
#include "system/solve.hpp"

namespace keyblock::block_iterations_test {
namespace {

using Block = BlockMatrix::Block;

// A wall of blocks with springs to their neighbours: inertia 1 on the diagonal, springs of `stiffness` between.
System wall(int rows, int columns, double stiffness, const std::vector<int>& sizes = {6}) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> value(-1, 1);
  std::vector<int> all;
  for (int i = 0; i < rows * columns; ++i) all.push_back(sizes[static_cast<std::size_t>(i) % sizes.size()]);
  System system(all);
  const auto couple = [&](int a, int b) {
    for (int spring = 0; spring < 2; ++spring) {
      Eigen::VectorXd on_a(system.matrix.size(a));
      Eigen::VectorXd on_b(system.matrix.size(b));
      for (double& x : on_a) x = value(random);
      for (double& x : on_b) x = value(random);
      system.matrix.add(a, a, stiffness * on_a * on_a.transpose());
      system.matrix.add(b, b, stiffness * on_b * on_b.transpose());
      system.matrix.add(a, b, stiffness * on_a * on_b.transpose());
    }
  };
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < columns; ++c) {
      const int i = r * columns + c;
      system.matrix.add(i, i, Block::Identity(system.matrix.size(i), system.matrix.size(i)));
      if (c > 0) couple(i, i - 1);
      if (r > 0) couple(i, i - columns);
    }
  }
  for (double& x : system.load) x = value(random);
  return system;
}

double residual(const System& system, const Eigen::VectorXd& x) {
  return (system.load - system.matrix * x).norm() / system.load.norm();
}

constexpr IterationLimits kLimits{1e-11, 2000};

Eigen::VectorXd none(const System& system) {
  return Eigen::VectorXd::Zero(system.load.size());
}

Eigen::SparseMatrix<double> lower_of(const BlockMatrix& matrix) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < matrix.block_count(); ++i)
    for (const auto& [j, block] : matrix.row(i))
      for (int r = 0; r < block.rows(); ++r)
        for (int c = 0; c < block.cols(); ++c)
          if (i != j || c <= r)
            entries.emplace_back(matrix.first_row(j) + (i == j ? r : c), matrix.first_row(i) + (i == j ? c : r),
                                 block(r, c));
  Eigen::SparseMatrix<double> lower(matrix.row_count(), matrix.row_count());
  lower.setFromTriplets(entries.begin(), entries.end());
  return lower;
}

}  // namespace

TEST(BlockIterations, gradients_reach_the_solution_for_every_size_of_block) {
  for (const std::vector<int>& sizes : {std::vector{6}, {3}, {2}, {6, 3, 2}}) {
    const System system = wall(7, 9, 30, sizes);
    const IterationResult result = conjugate_gradients(system.matrix, system.load, none(system), kLimits);
    EXPECT_TRUE(result.converged);
    EXPECT_LT(residual(system, result.x), 2e-11);
    Solver solver;
    solver.method = LinearMethod::factor;
    EXPECT_LT((solver.solve(system)->x - result.x).norm(), 1e-9 * result.x.norm());
  }
}

// Directions in single precision must not be lost when the residual is formed anew: an independent program with a worse
// preconditioner, all in double, sets the bound.
TEST(BlockIterations, gradients_of_stiff_walls_need_fewer_iterations_than_eigens_with_a_diagonal) {
  for (const double stiffness : {1e2, 1e3, 1e4}) {
    const System system = wall(20, 20, stiffness);
    Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower> eigen;
    eigen.setTolerance(1e-11);
    eigen.setMaxIterations(20000);
    const Eigen::SparseMatrix<double> lower = lower_of(system.matrix);
    eigen.compute(lower);
    const Eigen::VectorXd x = eigen.solve(system.load);
    ASSERT_EQ(eigen.info(), Eigen::Success);
    const IterationResult ours = conjugate_gradients(system.matrix, system.load, none(system), {1e-11, 20000});
    EXPECT_TRUE(ours.converged);
    EXPECT_LT(ours.iterations, eigen.iterations()) << stiffness;
    EXPECT_LT((ours.x - x).norm(), 1e-6 * x.norm()) << stiffness;
  }
}

TEST(BlockIterations, a_good_guess_saves_iterations) {
  const System system = wall(10, 10, 30);
  const IterationResult cold = conjugate_gradients(system.matrix, system.load, none(system), kLimits);
  const IterationResult warm = conjugate_gradients(system.matrix, system.load, 1.000001 * cold.x, kLimits);
  EXPECT_LT(warm.iterations, cold.iterations);
  EXPECT_EQ(conjugate_gradients(system.matrix, system.load, cold.x, {1e-10, 10}).iterations, 0);
}

TEST(BlockIterations, an_end_before_the_goal_is_said) {
  const System system = wall(10, 10, 1e4);
  EXPECT_FALSE(conjugate_gradients(system.matrix, system.load, none(system), {1e-11, 3}).converged);
  EXPECT_FALSE(over_relaxation(system.matrix, system.load, none(system), 1.4, {1e-11, 3}).converged);
}

TEST(BlockIterations, over_relaxation_reaches_the_solution_where_inertia_rules) {
  const System system = wall(6, 6, 0.5);
  const IterationResult result = over_relaxation(system.matrix, system.load, none(system), 1.3, kLimits);
  EXPECT_TRUE(result.converged);
  EXPECT_LT(residual(system, result.x), 2e-11);
}

// Two blocks pushed together by an inadmissible spring: −2 on the diagonal of a matrix that has 1.
TEST(BlockIterations, an_indefinite_matrix_is_no_success) {
  System system({2, 2});
  system.matrix.add(0, 0, Block::Identity(2, 2));
  system.matrix.add(1, 1, -2 * Block::Identity(2, 2));
  system.load.setOnes();
  EXPECT_FALSE(conjugate_gradients(system.matrix, system.load, none(system), kLimits).converged);
}

TEST(BlockIterations, nothing_is_solved_by_nothing) {
  System system = wall(4, 4, 30);
  const Eigen::VectorXd guess = Eigen::VectorXd::Ones(system.load.size());
  system.load.setZero();
  const System none_at_all(std::vector<int>(5, 0));
  for (const IterationResult& result :
       {conjugate_gradients(system.matrix, system.load, guess, kLimits),
        over_relaxation(system.matrix, system.load, guess, 1.3, kLimits),
        conjugate_gradients(none_at_all.matrix, none_at_all.load, none(none_at_all), kLimits)}) {
    EXPECT_TRUE(result.converged);
    EXPECT_EQ(result.residual, 0);
    EXPECT_EQ(result.x.norm(), 0);
  }
}

// Single precision cannot gain anything here; the result is no worse than the start.
TEST(BlockIterations, a_matrix_beyond_single_precision_ends_soon_with_the_best_that_was_found) {
  for (const double stiffness : {1e6, 1e7, 1e9}) {
    const System system = wall(20, 20, stiffness);
    const IterationResult result = conjugate_gradients(system.matrix, system.load, none(system), {1e-11, 100000});
    EXPECT_FALSE(result.converged);
    EXPECT_LE(result.residual, 1);
    EXPECT_NEAR(residual(system, result.x), result.residual, 1e-12);
    EXPECT_LT(result.iterations, 5000);
  }
}

TEST(BlockIterations, bits_do_not_depend_on_threads) {
  const System system = wall(100, 100, 3, {2});  // so many that light loops take threads
  context().use_threads(1);
  const Eigen::VectorXd one = conjugate_gradients(system.matrix, system.load, none(system), kLimits).x;
  for (const int threads : {2, 4}) {
    context().use_threads(threads);
    EXPECT_EQ(conjugate_gradients(system.matrix, system.load, none(system), kLimits).x, one);
  }
  context().use_threads(0);
}

TEST(Solver, chooses_iterations_by_inertia_and_number_and_keeps_to_the_factor_once_they_fail) {
  Solver solver;
  const System light = wall(20, 20, 1);
  ASSERT_TRUE(solver.solve(light, {1, none(light)}));
  EXPECT_FALSE(solver.gave_up_iterations);
  const System stiff = wall(20, 20, 1e7);
  const auto solution = solver.solve(stiff, {1, none(stiff)});  // marked as easy
  ASSERT_TRUE(solution);
  EXPECT_LT(solution->residual, 1e-8);
  EXPECT_TRUE(solver.gave_up_iterations);
}

// Shi's programs accept the result of their sweeps as a solution; Keyblock must not.
TEST(Solver, over_relaxation_that_does_not_end_is_no_solution) {
  Solver solver;
  solver.method = LinearMethod::over_relaxation;
  EXPECT_FALSE(solver.solve(wall(12, 12, 1e6)));
  const System light = wall(6, 6, 0.5);
  const auto solution = solver.solve(light);
  ASSERT_TRUE(solution);
  EXPECT_LT(solution->residual, 2e-11);
}

// Positive definite, but the incomplete factorisation of its ring of four blocks is not: 1 beside 0.7 three times and
// −0.7 once.
TEST(BlockIterations, a_raised_diagonal_makes_a_factor_where_the_pattern_alone_does_not) {
  System system({2, 2, 2, 2});
  const Block one = Block::Identity(2, 2);
  for (int i = 0; i < 4; ++i) system.matrix.add(i, i, one);
  for (const auto& [i, j, c] : {std::tuple{0, 1, 0.7}, {1, 2, 0.7}, {2, 3, 0.7}, {0, 3, -0.7}})
    system.matrix.add(i, j, c * one);
  system.load.setLinSpaced(1, 2);
  const IterationResult result = conjugate_gradients(system.matrix, system.load, none(system), kLimits);
  EXPECT_TRUE(result.converged);
  EXPECT_LT(residual(system, result.x), 2e-11);
}

TEST(Solver, solves_what_is_regular_but_not_positive) {
  System system({2, 2});
  system.matrix.add(0, 0, Block::Identity(2, 2));
  system.matrix.add(1, 1, -2 * Block::Identity(2, 2));
  system.matrix.add(0, 1, Block::Identity(2, 2));
  system.load << 1, 2, 3, 4;
  const auto solution = Solver().solve(system);
  ASSERT_TRUE(solution);
  EXPECT_LT(solution->residual, 1e-15);
}

}  // namespace keyblock::block_iterations_test
