// Contact forces by Newton's method beside closed forms: a block on its corners that sticks, slides, tips or lifts off.
// Random bodies, whose forces are checked by the conditions themselves.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/solve/friction_newton.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <random>
#include <utility>
#include <vector>

#include "contact/solve/active_forces.hpp"

namespace keyblock::friction_newton_test {
namespace {

constexpr double kMass = 2, kSpin = 3, kArm = 0.7, kHeight = 0.4;  // of the block; kSpin is its moment of inertia
constexpr double kGravity = 9;

/// A point of a rigid body at x, y from its centroid, on a floor: its velocity upward and along the floor.
struct Foot {
  double x = 0;
  double y = 0;

  Eigen::RowVector3d normal() const { return {0, 1, x}; }
  Eigen::RowVector3d tangential() const { return {1, 0, -y}; }
};

const std::vector<Foot> kTwoFeet{{-kArm, -kHeight}, {kArm, -kHeight}};

Eigen::Matrix3d inverse_mass() {
  return Eigen::Vector3d(1 / kMass, 1 / kMass, 1 / kSpin).asDiagonal();
}

/// The block with the velocity `free` that it would have without contact.
FrictionalProblem block_on(const std::vector<Foot>& feet, const Eigen::Vector3d& free, double friction) {
  ContactRows rows;
  Eigen::VectorXd b(static_cast<Eigen::Index>(2 * feet.size()));
  for (const Foot& foot : feet)
    for (const Eigen::RowVector3d& row : {foot.normal(), foot.tangential()}) {
      b[static_cast<Eigen::Index>(rows.size())] = row.dot(free);
      rows.push_back({{0}, {0}, row, Eigen::RowVector3d::Zero()});
    }
  return {ContactMatrix(rows, {{UnknownBlock(inverse_mass())}}),
          b,
          std::vector<ForceLaw>(feet.size(), {friction}),
          1e-12,
          1e-12,
          {}};
}

/// After a push P along the floor, `above` the centroid, and the weight, each for a unit of time.
Eigen::Vector3d pushed(double push, double above) {
  return {push / kMass, -kGravity, -push * above / kSpin};
}

FrictionalSolution forces_of(const FrictionalProblem& problem) {
  return newton(problem, Eigen::VectorXd::Zero(problem.b.size()));
}

Eigen::Vector3d velocity_after(const FrictionalProblem& problem, const Eigen::Vector3d& free,
                               const Eigen::VectorXd& forces) {
  Eigen::Vector3d v = free;
  for (Eigen::Index i = 0; i < forces.size(); ++i)
    v += inverse_mass() * problem.w.row(i).of_vertex.transpose() * forces[i];
  return v;
}

/// Returns the largest violation of the laws of contact and friction, in the unit of forces, for a dense W. A force
/// times its rate counts as the root of it over the compliance.
double violation(const Eigen::MatrixXd& w, const Eigen::VectorXd& b, const std::vector<ForceLaw>& laws,
                 const Eigen::VectorXd& forces) {
  const Eigen::VectorXd y = w * forces + b;
  double most = 0;
  const auto add = [&](double value) { most = std::max(most, value); };
  for (std::size_t i = 0; i < laws.size(); ++i) {
    const auto n = static_cast<Eigen::Index>(2 * i);
    const double along = forces[n + 1], limit = laws[i].friction * forces[n];
    const double gap = y[n] / w(n, n), slip = y[n + 1] / w(n + 1, n + 1);
    add(-forces[n]);
    add(-gap);
    add(std::min(forces[n], gap));
    add(std::abs(along) - limit);
    // Either nothing slips, or the whole of friction is against the slip.
    add(std::min(std::abs(slip), std::abs(along + (slip > 0 ? limit : -limit))));
  }
  return most;
}

/// Up to three rigid bodies on the plane and on each other, with as many contacts.
struct RandomBodies {
  Eigen::MatrixXd w;
  FrictionalProblem problem;
};

RandomBodies random_bodies(std::mt19937& random, double most_friction, double spring) {
  std::uniform_real_distribution<double> any(-1, 1), part(0, 1);
  const int bodies = std::uniform_int_distribution(1, 3)(random);
  const int contacts = std::uniform_int_distribution(1, 5)(random);
  Flexibility flexibility;
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(3 * bodies, 3 * bodies);
  for (int i = 0; i < bodies; ++i) {
    const double mass = std::exp2(3 * any(random));
    const Eigen::Matrix3d block = Eigen::Vector3d(1 / mass, 1 / mass, 6 / mass).asDiagonal();
    flexibility.blocks.push_back(block);
    all.block<3, 3>(3 * i, 3 * i) = block;
  }
  Eigen::VectorXd free(3 * bodies);
  for (double& entry : free) entry = any(random);
  ContactRows rows;
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(2 * contacts, 3 * bodies);
  std::vector<ForceLaw> laws;
  for (int i = 0; i < contacts; ++i) {
    const int upper = std::uniform_int_distribution(0, bodies - 1)(random);
    const int lower = std::uniform_int_distribution(-1, upper - 1)(random);  // -1: the plane
    const Eigen::Vector2d normal = Eigen::Vector2d(any(random), any(random)).normalized();
    const Eigen::Vector2d arm(any(random), any(random)), other(any(random), any(random));
    for (int k = 0; k < 2; ++k) {
      const Eigen::Vector2d along = k == 0 ? normal : Eigen::Vector2d(normal[1], -normal[0]);
      const auto row_at = [&](const Eigen::Vector2d& at) {
        return Eigen::RowVector3d(along[0], along[1], at[0] * along[1] - at[1] * along[0]);
      };
      dense.block<1, 3>(2 * i + k, 3 * upper) = row_at(arm);
      if (lower >= 0) dense.block<1, 3>(2 * i + k, 3 * lower) = -row_at(other);
      ContactRow row{{upper}, {std::max(lower, 0)}, row_at(arm), Eigen::RowVector3d::Zero()};
      if (lower >= 0) row.of_edge = -row_at(other);
      rows.push_back(row);
    }
    laws.push_back({most_friction * part(random)});
  }
  RandomBodies made{dense * all * dense.transpose(), {ContactMatrix(rows, flexibility), dense * free, laws, 0, 0, {}}};
  for (Eigen::Index i = 0; spring > 0 && i < 2 * contacts; ++i) {
    made.problem.w.add_to_diagonal(i, spring);
    made.w(i, i) += spring;
  }
  made.problem.goal = 1e-13 * made.problem.b.cwiseAbs().maxCoeff() / made.w.diagonal().minCoeff();
  made.problem.acceptable = 1e4 * made.problem.goal;
  return made;
}

}  // namespace

// Both corners carry load: together the weight, and the couple of the push about the floor. They differ by P (h +
// above)/a.
TEST(FrictionNewton, a_block_that_sticks_bears_weight_push_and_couple) {
  for (const double push : {-3.0, 0.0, 2.0, 5.0}) {
    const Eigen::Vector3d free = pushed(push, 0.2);
    const FrictionalProblem problem = block_on(kTwoFeet, free, 0.5);
    const FrictionalSolution found = forces_of(problem);
    EXPECT_TRUE(found.converged);
    EXPECT_NEAR(found.forces[0] + found.forces[2], kMass * kGravity, 1e-11);
    EXPECT_NEAR(found.forces[2] - found.forces[0], push * (kHeight + 0.2) / kArm, 1e-11);
    EXPECT_NEAR(found.forces[1] + found.forces[3], -push, 1e-11);
    EXPECT_LT(velocity_after(problem, free, found.forces).norm(), 1e-11);
  }
}

// Friction is μ m g in all, at the floor: the block moves with P/m - μ g, and does not rotate.
TEST(FrictionNewton, a_block_that_slides_is_slowed_by_its_weight_times_friction) {
  for (const double push : {6.0, -6.0}) {
    const double sign = push > 0 ? 1 : -1, friction = 0.2;
    const Eigen::Vector3d free = pushed(push, 0.1);
    const FrictionalProblem problem = block_on(kTwoFeet, free, friction);
    const FrictionalSolution found = forces_of(problem);
    EXPECT_TRUE(found.converged);
    for (const Eigen::Index n : {0, 2}) {
      EXPECT_GT(found.forces[n], 0);
      EXPECT_NEAR(found.forces[n + 1], -sign * friction * found.forces[n], 1e-12);
    }
    const double couple = push * 0.1 + kHeight * sign * friction * kMass * kGravity;
    EXPECT_NEAR(found.forces[2] - found.forces[0], couple / kArm, 1e-11);
    const Eigen::Vector3d after = velocity_after(problem, free, found.forces);
    EXPECT_LT((after - Eigen::Vector3d(push / kMass - sign * friction * kGravity, 0, 0)).norm(), 1e-11);
  }
}

// Only push and weight rotate the block about the corner that stays: L = a m g - P (h + above). It rotates at L/(J + m
// (a² + h²)).
TEST(FrictionNewton, a_block_that_tips_turns_about_the_corner_that_stays) {
  const double push = 30, above = 0.5;
  const Eigen::Vector3d free = pushed(push, above);
  const FrictionalProblem problem = block_on(kTwoFeet, free, 5);
  const FrictionalSolution found = forces_of(problem);
  EXPECT_TRUE(found.converged);
  const double turn =
      (kArm * kMass * kGravity - push * (kHeight + above)) / (kSpin + kMass * (kArm * kArm + kHeight * kHeight));
  ASSERT_LT(turn, 0);
  const Eigen::Vector3d expected(-turn * kHeight, -turn * kArm, turn);
  EXPECT_LT((velocity_after(problem, free, found.forces) - expected).norm(), 1e-11);
  EXPECT_NEAR(found.forces[0], 0, 1e-12);
  EXPECT_NEAR(found.forces[1], 0, 1e-12);
  EXPECT_NEAR(found.forces[2], kMass * (expected[1] - free[1]), 1e-11);
  EXPECT_NEAR(found.forces[3], kMass * (expected[0] - free[0]), 1e-11);
}

TEST(FrictionNewton, a_block_that_rises_has_no_forces_wherever_the_search_begins) {
  const FrictionalProblem problem = block_on(kTwoFeet, {3, 1, 0.2}, 0.5);
  for (const double start : {0.0, 1.0, 100.0}) {
    const FrictionalSolution found = newton(problem, Eigen::VectorXd::Constant(4, start));
    EXPECT_TRUE(found.converged) << start;
    EXPECT_LT(found.forces.cwiseAbs().maxCoeff(), 1e-12) << start;
  }
}

TEST(FrictionNewton, without_friction_nothing_acts_along_the_floor) {
  for (const double push : {0.0, 1.0, -20.0}) {
    const Eigen::Vector3d free = pushed(push, 0);
    const FrictionalProblem problem = block_on(kTwoFeet, free, 0);
    const FrictionalSolution found = forces_of(problem);
    EXPECT_TRUE(found.converged) << push;
    EXPECT_LT((found.forces - Eigen::Vector4d(9, 0, 9, 0)).norm(), 1e-11) << push;
    EXPECT_NEAR(velocity_after(problem, free, found.forces)[0], push / kMass, 1e-12);
  }
}

// The matrix has rank three of ten: the distribution of the load among five feet is open, their resultant is not.
TEST(FrictionNewton, five_feet_bear_what_two_would) {
  const std::vector<Foot> feet{{-kArm, -kHeight}, {-0.2, -kHeight}, {0.1, -kHeight}, {0.5, -kHeight}, {kArm, -kHeight}};
  for (const double push : {2.0, -3.0, 8.0}) {
    const Eigen::Vector3d free = pushed(push, 0.2);
    const FrictionalProblem problem = block_on(feet, free, 0.5);
    const FrictionalProblem few = block_on(kTwoFeet, free, 0.5);
    const FrictionalSolution found = forces_of(problem);
    EXPECT_TRUE(found.converged) << push;
    const Eigen::Vector3d difference =
        velocity_after(problem, free, found.forces) - velocity_after(few, free, forces_of(few).forces);
    EXPECT_LT(difference.norm(), 1e-9) << push;
    for (std::size_t i = 0; i < feet.size(); ++i) {
      const auto n = static_cast<Eigen::Index>(2 * i);
      EXPECT_GE(found.forces[n], -1e-9);
      EXPECT_LE(std::abs(found.forces[n + 1]), 0.5 * found.forces[n] + 1e-9);
    }
  }
}

// Two springs of compliance c at one place under a unit mass: λ1 = λ2 = P/(2 + c), W being 1 between them.
TEST(FrictionNewton, springs_at_one_place_share_the_load) {
  for (const double compliance : {1e-6, 0.5, 10.0}) {
    ContactRows rows;
    for (int i = 0; i < 2; ++i)
      for (int k = 0; k < 2; ++k) rows.push_back({{0}, {0}, Eigen::RowVector2d::Unit(k), Eigen::RowVector2d::Zero()});
    FrictionalProblem problem{ContactMatrix(rows, {{UnknownBlock(Eigen::Matrix2d::Identity())}}),
                              Eigen::Vector4d(-10, 1, -10, 1),
                              {{0.5}, {0.5}},
                              1e-12,
                              1e-12,
                              {}};
    for (Eigen::Index i = 0; i < 4; ++i) problem.w.add_to_diagonal(i, compliance);
    const FrictionalSolution found = forces_of(problem);
    EXPECT_TRUE(found.converged);
    const double expected = 10 / (2 + compliance);
    EXPECT_LT((found.forces - Eigen::Vector4d(expected, -expected / 10, expected, -expected / 10)).norm(), 1e-9)
        << compliance;
  }
}

// About one problem in a thousand stays open even under little friction; the detour by the interior then solves it.
TEST(FrictionNewton, random_bodies_of_little_friction_obey_the_laws_of_contact) {
  std::mt19937 random(7);
  int open = 0;
  for (int i = 0; i < 200; ++i) {
    const auto [w, problem] = random_bodies(random, 0.1, 0);
    FrictionalSolution found = forces_of(problem);
    if (!found.converged) {
      ++open;
      found = solve(problem, found.forces);
    }
    EXPECT_TRUE(found.converged) << i;
    EXPECT_LE(violation(w, problem.b, problem.laws, found.forces), 2 * problem.acceptable) << i;
    EXPECT_LE(found.residual, problem.acceptable) << i;
  }
  EXPECT_LE(open, 2);
}

// Some of these stay open without the detour; Newton's method must not report those as solved.
TEST(FrictionNewton, what_counts_as_solved_obeys_the_laws_of_contact) {
  std::mt19937 random(8);
  int solved = 0, by_springs = 0;
  for (int i = 0; i < 200; ++i) {
    const bool has_springs = i % 2 == 1;
    const auto [w, problem] = random_bodies(random, 1, has_springs ? 0.01 : 0);
    const FrictionalSolution found = forces_of(problem);
    if (!found.converged) continue;
    (has_springs ? by_springs : solved) += 1;
    EXPECT_LE(violation(w, problem.b, problem.laws, found.forces), 2 * problem.acceptable) << i;
  }
  EXPECT_GE(solved, 95);
  EXPECT_GE(by_springs, 95);
}

TEST(FrictionNewton, forces_that_are_solved_cost_nothing_and_counts_go_on) {
  FrictionalProblem problem = block_on(kTwoFeet, pushed(2, 0.2), 0.5);
  const FrictionalSolution first = forces_of(problem);
  EXPECT_GT(first.solves, 0);
  FrictionalSolution so_far{Eigen::VectorXd::Zero(4), residual(problem, Eigen::VectorXd::Zero(4)), 5, 1, false, {}};
  const FrictionalSolution second = newton(problem, so_far);
  EXPECT_EQ(second.solves, 5 + first.solves);
  EXPECT_EQ(second.fallbacks, 1);
  EXPECT_EQ(second.forces, first.forces);
  problem.goal = problem.acceptable = 1e-8;
  EXPECT_EQ(newton(problem, first.forces).solves, 0);
}

// The same active set under other loads: one block that carries load, pressed twice as hard.
TEST(FrictionNewton, a_kept_system_serves_other_loads) {
  FrictionalProblem problem = block_on({{0, -kHeight}}, pushed(1, -kHeight), 0.5);
  KeptSystem kept;
  const auto from_none = [&](KeptSystem* with) {
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(2);
    return newton(problem, {none, residual(problem, none), 0, 0, false, {}}, with);
  };
  EXPECT_GT(from_none(&kept).solves, 0);
  problem.b *= 2;
  const FrictionalSolution alone = from_none(nullptr), again = from_none(&kept);
  EXPECT_LT(again.solves, alone.solves);
  EXPECT_LT((again.forces - Eigen::Vector2d(2 * kMass * kGravity, -2)).norm(), 1e-11);
}

}  // namespace keyblock::friction_newton_test
