// Small linear systems of pairs compared with dense algebra; a matrix that is not positive definite is refused by name.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/sparse_solve.hpp"

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <Eigen/SparseCore>
#include <array>
#include <filesystem>
#include <vector>

#include "base/context.hpp"
#include "base/loop.hpp"
#include "system/cholmod/sparse_factor.hpp"

namespace keyblock::sparse_solve_test {
namespace {

constexpr std::array<int, 2> kFirst{2, 0};
constexpr std::array<int, 2> kSecond{1, 2};

/// Three functions; 0 and 1 do not couple.
SparseSystem system_of(const Eigen::Matrix4d& block) {
  FunctionGroups groups;
  groups.add(kFirst);
  groups.add(kSecond);
  SparseSystem system(3, groups);
  system.add_matrix(kFirst, block);
  system.add_matrix(kSecond, block);
  system.add_load(kFirst, Eigen::Vector4d(1, 2, 3, 4));
  return system;
}

Eigen::Matrix4d positive() {
  Eigen::Matrix4d block;
  block << 5, 1, -2, 0.5, 1, 6, 0.3, -1, -2, 0.3, 7, 1, 0.5, -1, 1, 8;
  return block;
}

}  // namespace

TEST(SparseSolve, blocks_of_pairs_give_the_dense_solution) {
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(6, 6);
  Eigen::VectorXd load = Eigen::VectorXd::Zero(6);
  for (const auto& functions : {kFirst, kSecond}) {
    for (int a = 0; a < 2; ++a) {
      for (int b = 0; b < 2; ++b)
        dense.block<2, 2>(2 * functions[a], 2 * functions[b]) += positive().block<2, 2>(2 * a, 2 * b);
    }
  }
  load << 3, 4, 0, 0, 1, 2;
  const SparseSystem system = system_of(positive());
  EXPECT_EQ((system.load() - load).norm(), 0);
  const SparseSolution solution = solve(system, Definiteness::definite);
  EXPECT_LT((solution.x - dense.ldlt().solve(load)).norm(), 1e-14);
  EXPECT_LT(solution.residual, 1e-15);
}

TEST(SparseSolve, what_is_not_positive_definite_is_refused) {
  Eigen::Matrix4d block = positive();
  block(2, 2) = 0.5;
  EXPECT_THROW(solve(system_of(block), Definiteness::definite), NotPositiveDefinite);
  EXPECT_THROW(solve(system_of(Eigen::Matrix4d::Zero()), Definiteness::definite), NotPositiveDefinite);
}

// CHOLMOD would use four at fronts of this size, for any number of threads of the run.
TEST(SparseSolve, a_run_of_one_thread_has_no_other_while_it_factorises) {
  const std::filesystem::path tasks = "/proc/self/task";
  if (!std::filesystem::exists(tasks)) GTEST_SKIP() << "threads are not listed here";
  const auto count = [&] {
    return std::distance(std::filesystem::directory_iterator(tasks), std::filesystem::directory_iterator());
  };
  constexpr int kSide = 80;  // of a grid of springs, each node supported a little
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < kSide * kSide; ++i) {
    entries.emplace_back(i, i, 4.01);
    if (i % kSide + 1 < kSide) entries.emplace_back(i + 1, i, -1);
    if (i + kSide < kSide * kSide) entries.emplace_back(i + kSide, i, -1);
  }
  Eigen::SparseMatrix<double> lower(kSide * kSide, kSide * kSide);
  lower.setFromTriplets(entries.begin(), entries.end());
  const int wanted = loop_threads();
  context().use_threads(1);
  const auto before = count();
  SparseFactor factor(lower, Definiteness::definite);
  factor.factorise(lower);
  EXPECT_EQ(count(), before);
  context().use_threads(wanted);
}

// Springs between the functions only: all may move together, which a load without resultant does not.
TEST(SparseSolve, a_semidefinite_matrix_is_solved_where_it_carries_the_load) {
  Eigen::Matrix4d spring = Eigen::Matrix4d::Identity();
  spring.topRightCorner<2, 2>() = spring.bottomLeftCorner<2, 2>() = -Eigen::Matrix2d::Identity();
  SparseSystem system = system_of(spring);
  EXPECT_THROW(solve(system, Definiteness::definite), NotPositiveDefinite);
  EXPECT_THROW(solve(system, Definiteness::semidefinite), NotPositiveDefinite) << "the load has a resultant";
  system.add_load(kSecond, Eigen::Vector4d(-4, -6, 0, 0));
  const SparseSolution solution = solve(system, Definiteness::semidefinite);
  EXPECT_LT(solution.residual, 1e-14);
  EXPECT_NEAR(solution.x(0) - solution.x(4), 3, 1e-4);
  EXPECT_NEAR(solution.x(4) - solution.x(2), 4, 1e-4);
}

// The caller of the library may have parallel regions of its own.
TEST(SparseSolve, a_factorisation_leaves_the_levels_of_openmp_as_they_were) {
  Eigen::SparseMatrix<double> matrix(3, 3);
  matrix.setIdentity();
  SparseFactor factor(matrix, Definiteness::definite);
  factor.factorise(matrix);  // loads the library
  const auto set = reinterpret_cast<void (*)(int)>(dlsym(RTLD_DEFAULT, "omp_set_max_active_levels"));
  const auto levels = reinterpret_cast<int (*)()>(dlsym(RTLD_DEFAULT, "omp_get_max_active_levels"));
  if (!set || !levels) GTEST_SKIP() << "CHOLMOD was built without OpenMP";
  constexpr int kOfCaller = 3;
  const int before = levels();
  set(kOfCaller);
  factor.factorise(matrix);
  EXPECT_EQ(levels(), kOfCaller);
  set(before);
}

}  // namespace keyblock::sparse_solve_test
