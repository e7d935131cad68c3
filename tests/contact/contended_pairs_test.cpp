// Few pairs among others: their states as the whole problem has them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/solve/contended_pairs.hpp"

#include <gtest/gtest.h>

#include <random>

#include "contact/solve/friction_newton.hpp"

namespace keyblock::contended_pairs_test {
namespace {

// Bodies of unit mass in a row, each pressed against its neighbour at two points; all pushed along with random forces.
FrictionalProblem row_of(int bodies, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-1, 1);
  Table<ElementIndex, UnknownBlock> flexibility;
  for (int i = 0; i < bodies; ++i) flexibility.push_back(UnknownBlock(Eigen::Matrix3d::Identity()));
  ContactRows rows;
  FrictionalProblem problem;
  for (int i = 0; i + 1 < bodies; ++i)
    for (const double arm : {-0.5, 0.5}) {
      const Eigen::RowVector3d normal(0, 1, arm), tangential(1, 0, 0.4);
      const Eigen::RowVector3d other(0, -1, -arm), across(-1, 0, 0.4);
      rows.push_back({{i + 1}, {i}, normal, other});
      rows.push_back({{i + 1}, {i}, tangential, across});
      problem.laws.push_back({0.6});
    }
  problem.w = ContactMatrix(rows, {flexibility});
  problem.b = Eigen::VectorXd::NullaryExpr(problem.w.rows(), [&] { return any(random) - 0.3; });
  for (Eigen::Index i = 0; i < problem.w.rows(); ++i) problem.w.add_to_diagonal(i, 0.05);
  problem.goal = problem.acceptable = 1e-10;
  return problem;
}

}  // namespace

TEST(ContendedPairs, dense_forces_are_those_of_the_problem) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const FrictionalProblem problem = row_of(6, seed);
    const auto count = problem.w.rows();
    DenseFriction dense{Eigen::MatrixXd(count, count), problem.b, problem.laws};
    for (Eigen::Index i = 0; i < count; ++i) dense.w.col(i) = problem.w * Eigen::VectorXd::Unit(count, i);
    const Eigen::VectorXd forces = solve_dense(dense, Eigen::VectorXd::Zero(count), 1e-10);
    EXPECT_LE(residual(problem, forces), 2e-10) << seed;
  }
}

// All but three pairs have the states of the solution; those three are told anything.
TEST(ContendedPairs, few_pairs_find_their_states_among_those_of_all_others) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const FrictionalProblem problem = row_of(40, seed);
    const FrictionalSolution whole = solve(problem, Eigen::VectorXd::Zero(problem.b.size()));
    ASSERT_TRUE(whole.converged) << seed;
    const std::vector<Grip> wanted = natural_map(problem, whole.forces).grips;
    std::vector<Grip> grips = wanted;
    const std::vector<std::size_t> pairs{10, 11, 30};
    for (const std::size_t pair : pairs) grips[pair] = Grip::slip_forward;
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(problem.b.size());
    EXPECT_EQ(settled_among(problem, grips, pairs, none, problem.b, none), wanted) << seed;
  }
}

}  // namespace keyblock::contended_pairs_test
