// Forces through the interior of their bounds: random problems in which Newton's method cycles.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/solve/interior_forces.hpp"

#include <gtest/gtest.h>

#include <random>

#include "contact/solve/friction_newton.hpp"

namespace keyblock::interior_forces_test {
namespace {

struct Row {
  int bodies = 0;
  double friction = 0;
  double compliance = 0;
};

// Bodies of unit mass in a row, each pressed against its neighbour at two points; all pushed along with random forces.
FrictionalProblem row_of(const Row& row, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-1, 1);
  Table<ElementIndex, UnknownBlock> flexibility;
  for (int i = 0; i < row.bodies; ++i) flexibility.push_back(UnknownBlock(Eigen::Matrix3d::Identity()));
  ContactRows rows;
  FrictionalProblem problem;
  for (int i = 0; i + 1 < row.bodies; ++i)
    for (const double arm : {-0.5, 0.5}) {
      const Eigen::RowVector3d normal(0, 1, arm), tangential(1, 0, 0.4);
      const Eigen::RowVector3d other(0, -1, -arm), across(-1, 0, 0.4);
      rows.push_back({{i + 1}, {i}, normal, other});
      rows.push_back({{i + 1}, {i}, tangential, across});
      problem.laws.push_back({row.friction});
    }
  problem.w = ContactMatrix(rows, {flexibility});
  problem.b = Eigen::VectorXd::NullaryExpr(problem.w.rows(), [&] { return any(random) - 0.3; });
  for (Eigen::Index i = 0; i < problem.w.rows(); ++i) problem.w.add_to_diagonal(i, row.compliance);
  problem.goal = problem.acceptable = 1e-8;
  return problem;
}

FrictionalSolution from_none(const FrictionalProblem& problem) {
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(problem.w.rows());
  return interior_forces(problem, {none, residual(problem, none), 0, 0, false, {}});
}

}  // namespace

// Few contacts have a dense factorisation, many a sparse one. Soft springs let all paths end. With stiff ones, or none,
// forces are redundant and may not even exist (Painlevé 1895): ten paths of 320 have no end (counted in the output).
// Newton's method continues there.
TEST(InteriorForces, meet_coulombs_law_in_random_rows) {
  int missed = 0;
  for (const int bodies : {6, 40})
    for (const double friction : {0.0, 0.3, 0.6, 1.2})
      for (const double compliance : {0.05, 1e-4, 0.0})
        for (unsigned seed = 0; seed < 20; ++seed) {
          const FrictionalProblem problem = row_of({bodies, friction, compliance}, seed);
          const bool is_met = residual(problem, from_none(problem).forces) <= problem.goal;
          missed += is_met ? 0 : 1;
          if (compliance < 0.01 && friction > 0.5) continue;
          EXPECT_TRUE(is_met) << bodies << " bodies, friction " << friction << ", compliance " << compliance
                              << ", seed " << seed;
        }
  EXPECT_LE(missed, 12);
}

// Springs make forces unique below some friction: both ways lead to the same.
TEST(InteriorForces, are_those_of_newton_where_springs_make_them_unique) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    FrictionalProblem problem = row_of({40, 0.3, 0.05}, seed);
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(problem.w.rows());
    const FrictionalSolution exact = newton(problem, none);
    if (exact.residual > problem.goal) continue;  // the cycle that the detour is for
    EXPECT_LE((from_none(problem).forces - exact.forces).norm(), 1e-5 * exact.forces.norm()) << seed;
  }
}

// A contact that cannot slip keeps its shear when it is torn open; a fixed point carries any force.
TEST(InteriorForces, know_what_never_slips_and_what_is_held) {
  FrictionalProblem problem = row_of({6, 0.5, 0.01}, 1);
  problem.laws.front() = {0.5, std::numeric_limits<double>::infinity(), -0.01};
  problem.laws.back() = kHeld;
  const FrictionalSolution found = from_none(problem);
  EXPECT_LE(found.residual, problem.goal);
  EXPECT_LT(found.forces.minCoeff(), 0) << "one of them pulls";
}

// A normal force that pulls has no Coulomb law that a path could follow: the forces stay, and report the residual.
TEST(InteriorForces, leave_pulling_friction_as_it_is) {
  FrictionalProblem problem = row_of({6, 0.5, 0.01}, 1);
  problem.laws.front().least = -std::numeric_limits<double>::infinity();
  const FrictionalSolution left = from_none(problem);
  EXPECT_EQ(left.forces, Eigen::VectorXd::Zero(problem.w.rows()).eval());
  EXPECT_GT(left.residual, problem.goal);
}

}  // namespace keyblock::interior_forces_test
