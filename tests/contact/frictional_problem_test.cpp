// Contact with friction, small enough to solve by hand, and redundant.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/solve/frictional_problem.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "contact/solve/friction_newton.hpp"
#include "contact/solve/interior_forces.hpp"

namespace keyblock::frictional_problem_test {
namespace {

// Forces that act on the unknowns of one element each, whose flexibility is W.
ContactMatrix directly(const Eigen::MatrixXd& w) {
  ContactRows rows;
  for (Eigen::Index i = 0; i < w.rows(); ++i)
    rows.push_back({{0}, {0}, Eigen::RowVectorXd::Unit(w.cols(), i), Eigen::RowVectorXd::Zero(w.cols())});
  return {rows, {{UnknownBlock(w)}}};
}

// A unit mass over one contact, pressed with `press` and pushed with `push`.
FrictionalProblem one_contact(double press, double push, double friction) {
  return {directly(Eigen::Matrix2d::Identity()), Eigen::Vector2d(-press, push), {{friction}}, 1e-12, 1e-12, {}};
}

// The same mass on two contacts at one place: W has rank two of four.
FrictionalProblem twice(const FrictionalProblem& p) {
  FrictionalProblem two = p;
  two.w = ContactMatrix({p.w.row(0), p.w.row(1), p.w.row(0), p.w.row(1)}, p.w.flexibility());
  two.b = p.b.replicate(2, 1);
  two.laws.push_back(p.laws[0]);
  return two;
}

Eigen::VectorXd zeros(const FrictionalProblem& p) {
  return Eigen::VectorXd::Zero(p.b.size());
}

}  // namespace

TEST(FrictionalProblem, a_pushed_mass_sticks_slips_or_lifts_off) {
  const Eigen::VectorXd stuck = solve(one_contact(10, 3, 0.5), Eigen::Vector2d(0, 0)).forces;
  EXPECT_NEAR(stuck[0], 10, 1e-12);
  EXPECT_NEAR(stuck[1], -3, 1e-12);
  const Eigen::VectorXd slipping = solve(one_contact(10, -8, 0.5), Eigen::Vector2d(0, 0)).forces;
  EXPECT_NEAR(slipping[1], 5, 1e-12);
  const Eigen::VectorXd lifted = solve(one_contact(-1, 3, 0.5), Eigen::Vector2d(7, 7)).forces;
  EXPECT_EQ(lifted, Eigen::VectorXd(Eigen::Vector2d(0, 0)));
}

// The second mass has a millionth of the load, and so of the tolerances. Its force is wrong by a hundredth.
TEST(FrictionalProblem, each_force_is_judged_by_its_share_of_the_tolerances) {
  FrictionalProblem two{
      directly(Eigen::Matrix4d::Identity()), Eigen::Vector4d(-1e6, 0, -1, 0), {{0}, {0}}, 1e-4, 1, {}};
  const Eigen::Vector4d forces(1e6, 0, 1.01, 0);
  EXPECT_TRUE(is_acceptable(two, forces));
  two.share = Eigen::Vector4d(1, 1, 1e-6, 1e-6);
  EXPECT_FALSE(is_acceptable(two, forces));
  EXPECT_NEAR(residual(two, forces), 1e4, 1e-6);
  EXPECT_EQ(worst_pair(two, forces), 1);
  EXPECT_NEAR(solve(two, forces).forces[2], 1, 1e-10);
}

TEST(FrictionalProblem, redundant_contacts_carry_together_what_one_would) {
  const FrictionalProblem problem = twice(one_contact(10, 3, 0.5));
  const FrictionalSolution solution = solve(problem, zeros(problem));
  EXPECT_TRUE(solution.converged);
  EXPECT_NEAR(solution.forces[0] + solution.forces[2], 10, 1e-10);
  EXPECT_NEAR(solution.forces[1] + solution.forces[3], -3, 1e-10);
}

TEST(FrictionalProblem, the_interior_leads_to_what_newton_finds) {
  FrictionalProblem problem = one_contact(10, -8, 0.5);
  problem.w = directly(Eigen::Matrix2d{{2, 0.3}, {0.3, 1}});
  const FrictionalSolution exact = newton(problem, zeros(problem));
  const FrictionalSolution found =
      interior_forces(problem, {zeros(problem), residual(problem, zeros(problem)), 0, 0, false, {}});
  EXPECT_LE(found.residual, problem.acceptable);
  EXPECT_LE((exact.forces - found.forces).norm(), 1e-10);
}

// Two contacts on one bar: the far one opens. Its force must be zero to the bit, or it counts as closed.
TEST(FrictionalProblem, an_open_contact_has_no_force_at_all) {
  Eigen::Matrix4d w = Eigen::Matrix4d::Identity();
  w(0, 2) = w(2, 0) = 1e-17;
  const FrictionalProblem problem{directly(w), Eigen::Vector4d(-10, 0.1, 1e-9, 0.2), {{0.5}, {0.5}}, 1e-9, 1e-9, {}};
  const Eigen::VectorXd forces = solve(problem, Eigen::Vector4d(10, -0.1, 1e-11, 0)).forces;
  EXPECT_EQ(forces[2], 0);
  EXPECT_EQ(forces[3], 0);
}

// No linear system is made: the initial forces are near enough, and press a contact that opens with more than counts as
// zero.
TEST(FrictionalProblem, an_open_contact_keeps_what_is_more_than_none) {
  FrictionalProblem problem = one_contact(-1, 0, 0.5);
  problem.goal = problem.acceptable = 5000;
  const Eigen::Vector2d start(0.5, 0.1);
  EXPECT_EQ(solve(problem, start).forces, zeros(problem));
  problem.no_force = 0.2;
  EXPECT_EQ(solve(problem, start).forces, Eigen::VectorXd(Eigen::Vector2d(0.5, 0)));
}

// The bond is torn off the ground and pushed aside: its shear holds until it is removed.
TEST(FrictionalProblem, what_cannot_slip_keeps_its_shear_when_it_opens) {
  const double never = std::numeric_limits<double>::infinity();
  FrictionalProblem problem = one_contact(-10, 3, 0.5);
  problem.laws = {{0.5, never, -4}};
  for (const FrictionalSolution& solution :
       {newton(problem, zeros(problem)),
        interior_forces(problem, {zeros(problem), residual(problem, zeros(problem)), 0, 0, false, {}})}) {
    EXPECT_NEAR(solution.forces[0], -4, 1e-12);
    EXPECT_NEAR(solution.forces[1], -3, 1e-12);
  }
}

TEST(FrictionalProblem, a_solution_at_the_start_costs_no_solve) {
  const FrictionalProblem problem = one_contact(10, 3, 0.5);
  EXPECT_EQ(solve(problem, Eigen::Vector2d(10, -3)).solves, 0);
}

}  // namespace keyblock::frictional_problem_test
