// The forces of an active set satisfy its equations: few by a dense factorisation, many through the blocks or, on
// covers, by their own sparse equations, very many by iterations.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/solve/active_forces.hpp"

#include <gtest/gtest.h>

#include <random>

namespace keyblock::active_forces_test {
namespace {

// A chain of rigid and deformable elements, each pair of forces between two of them, the last between an element and
// itself.
FrictionalProblem chain(int elements, std::mt19937& engine) {
  std::uniform_real_distribution<double> number(-1, 1);
  const auto random = [&](int rows, int columns) {
    return Eigen::MatrixXd(Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return number(engine); }));
  };
  Table<ElementIndex, UnknownBlock> flexibility;
  for (int e = 0; e < elements; ++e) {
    const int size = e == 0 ? 0 : e % 3 == 0 ? 6 : 3;
    const Eigen::MatrixXd root = random(size, size);
    flexibility.push_back(UnknownBlock(root * root.transpose() + 0.1 * Eigen::MatrixXd::Identity(size, size)));
  }
  ContactRows rows;
  const auto size = [&](int e) { return static_cast<int>(flexibility[ElementIndex{e}].rows()); };
  for (int e = 0; e < elements; ++e) {
    const int other = e + 1 < elements ? e + 1 : e;
    for (int k = 0; k < 2; ++k)
      rows.push_back({{e}, {other}, ContactRow::Row(random(1, size(e))), ContactRow::Row(random(1, size(other)))});
  }
  FrictionalProblem problem;
  problem.w = ContactMatrix(rows, {flexibility});
  problem.b = random(2 * elements, 1);
  problem.laws.assign(static_cast<std::size_t>(elements), {0.4, 0.1, -0.2});
  return problem;
}

/// Bodies of three functions each, without coupling between bodies.
class SharedOfBodies : public SharedFlexibility {
 public:
  SharedOfBodies(std::vector<Eigen::MatrixXd> bodies, bool is_symmetric)
      : bodies_(std::move(bodies)), is_symmetric_(is_symmetric) {}
  Eigen::Index size() const override { return 6 * std::ssize(bodies_); }
  bool is_symmetric() const override { return is_symmetric_; }
  Eigen::MatrixXd times(const Eigen::MatrixXd& forces) const override {
    Eigen::MatrixXd answers(forces.rows(), forces.cols());
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      const auto first = static_cast<Eigen::Index>(6 * b);
      answers.middleRows(first, 6) = bodies_[b] * forces.middleRows(first, 6);
    }
    return answers;
  }

 private:
  std::vector<Eigen::MatrixXd> bodies_;
  bool is_symmetric_;
};

// A chain of NMM bodies with a block at its end.
FrictionalProblem chain_on_covers(int bodies, std::mt19937& engine, bool is_symmetric = true) {
  std::uniform_real_distribution<double> number(-1, 1);
  const auto random = [&](int rows, int columns) {
    return Eigen::MatrixXd(Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return number(engine); }));
  };
  const auto answer_of = [&](int size) {
    const Eigen::MatrixXd root = random(size, size);
    const Eigen::MatrixXd turn = is_symmetric ? Eigen::MatrixXd::Zero(size, size) : random(size, size);
    return Eigen::MatrixXd(root * root.transpose() + 0.1 * Eigen::MatrixXd::Identity(size, size) + turn -
                           turn.transpose());
  };
  std::vector<Eigen::MatrixXd> of_bodies;
  for (int b = 0; b < bodies; ++b) of_bodies.push_back(answer_of(6));
  Flexibility flexibility;
  flexibility.shared = std::make_shared<SharedOfBodies>(of_bodies, is_symmetric);
  flexibility.has_symmetric_blocks = is_symmetric;
  flexibility.blocks.assign(static_cast<std::size_t>(bodies), UnknownBlock(0, 0));
  flexibility.blocks.push_back(UnknownBlock(answer_of(3)));
  const auto entries_of = [&](int body, std::vector<SharedEntry>& entries) {
    for (int f = 0; f < 3; ++f) entries.push_back({3 * body + f, number(engine), number(engine)});
  };
  ContactRows rows;
  for (int b = 0; b < bodies; ++b)
    for (int k = 0; k < 2; ++k) {
      const bool is_last = b + 1 == bodies;
      ContactRow row{{b}, {b + 1}, ContactRow::Row(1, 0), ContactRow::Row(random(1, is_last ? 3 : 0)), {}};
      entries_of(b, row.shared);
      if (!is_last) entries_of(b + 1, row.shared);
      rows.push_back(row);
    }
  FrictionalProblem problem;
  problem.w = ContactMatrix(rows, flexibility);
  problem.b = random(2 * bodies, 1);
  problem.laws.assign(static_cast<std::size_t>(bodies), {0.4, 0.1, -0.2});
  return problem;
}

// `share`: of W, added to the diagonal, so that springs are stiff if it is small.
double misfit(const FrictionalProblem& problem, double share, bool iterates) {
  const auto elements = static_cast<int>(problem.count());
  std::vector<Grip> grips;
  for (int i = 0; i < elements; ++i)
    grips.push_back(std::array{Grip::stick, Grip::slip_forward, Grip::stick, Grip::open, Grip::slip_backward}[i % 5]);
  const Eigen::VectorXd added = share * problem.w.diagonal().array() + 1e-4;
  ActiveForces active(problem, grips, added);
  EXPECT_TRUE(active.is_regular());
  EXPECT_EQ(active.iterates(), iterates);
  const Eigen::VectorXd forces = active.solve(problem.b, Eigen::VectorXd::Zero(2 * elements), 1e-12).value();
  const Eigen::VectorXd y = problem.w * forces + added.cwiseProduct(forces) + problem.b;
  double worst = 0;
  for (int i = 0; i < elements; ++i) {
    const Eigen::Index n = 2 * i;
    const ForceLaw& law = problem.laws[static_cast<std::size_t>(i)];
    const Grip grip = grips[static_cast<std::size_t>(i)];
    const double slip = law.cohesion + law.friction * forces[n];
    worst = std::max(worst, std::abs(grip == Grip::open ? forces[n] - law.least : y[n]));
    if (grip == Grip::stick) worst = std::max(worst, std::abs(y[n + 1]));
    if (grip == Grip::open) worst = std::max(worst, std::abs(forces[n + 1]));
    if (grip == Grip::slip_forward) worst = std::max(worst, std::abs(forces[n + 1] - slip));
    if (grip == Grip::slip_backward) worst = std::max(worst, std::abs(forces[n + 1] + slip));
  }
  return worst;
}

double misfit(int elements, double share, bool iterates) {
  std::mt19937 engine(3);
  return misfit(chain(elements, engine), share, iterates);
}

}  // namespace

TEST(ActiveForces, few_and_many_meet_the_equations_of_their_active_set) {
  EXPECT_LE(misfit(10, 1e-3, false), 1e-11);
  EXPECT_LE(misfit(200, 1e-3, false), 1e-11);
}

TEST(ActiveForces, on_covers_they_meet_the_equations_of_their_active_set) {
  for (const int bodies : {10, 200}) {
    std::mt19937 engine(5);
    EXPECT_LE(misfit(chain_on_covers(bodies, engine), 1e-3, false), 1e-9) << bodies;
    EXPECT_LE(misfit(chain_on_covers(bodies, engine, false), 1e-3, false), 1e-9) << bodies;
  }
}

TEST(ContactMatrix, covers_couple_the_forces_on_a_body_and_no_others) {
  std::mt19937 engine(7);
  const FrictionalProblem problem = chain_on_covers(8, engine);
  for (Eigen::Index i = 0; i < problem.w.rows(); ++i) {
    Eigen::VectorXd row = Eigen::VectorXd::Zero(problem.w.rows());
    for (const CoupledRows::Entry& entry : problem.w.coupled().of(i)) {
      EXPECT_LE(std::abs(entry.row / 2 - i / 2), 1) << i;
      row[entry.row] = entry.value;
    }
    const Eigen::VectorXd column = problem.w * Eigen::VectorXd::Unit(problem.w.rows(), i);
    EXPECT_LE((row - column).norm(), 1e-13 * column.norm()) << i;
  }
}

TEST(ContactMatrix, bodies_need_not_answer_symmetrically) {
  std::mt19937 engine(7);
  const FrictionalProblem problem = chain_on_covers(8, engine, false);
  ContactRows rows;
  for (Eigen::Index i = 0; i < problem.w.rows(); ++i) rows.push_back(problem.w.row(i));
  Eigen::MatrixXd all(problem.w.rows(), problem.w.rows());
  for (Eigen::Index i = 0; i < problem.w.rows(); ++i) {
    const Eigen::VectorXd force = Eigen::VectorXd::Unit(problem.w.rows(), i);
    const Eigen::VectorXd expected = rates(rows, answer(rows, problem.w.flexibility(), force));
    all.col(i) = problem.w * force;
    EXPECT_LE((all.col(i) - expected).norm(), 1e-13 * expected.norm()) << i;
    for (const CoupledRows::Entry& entry : problem.w.coupled().of(i))
      EXPECT_NEAR(
          entry.value,
          rates(rows, answer(rows, problem.w.flexibility(), Eigen::VectorXd::Unit(problem.w.rows(), entry.row)))[i],
          1e-13 * problem.w.diagonal().maxCoeff());
  }
  EXPECT_GT((all - all.transpose()).norm(), 0.1 * all.norm());
}

TEST(ActiveForces, soft_springs_between_many_blocks_are_solved_by_iterations_as_well_as_asked) {
  EXPECT_LE(misfit(400, 0.1, true), 1e-10);
  EXPECT_LE(misfit(400, 1e-3, false), 1e-10);
}

// Two unit masses in line pressed against a wall by redundant forces that are required for gaps a rounding apart. No
// forces close both, and the rest is tolerated; a force that its law forbids is not.
TEST(FrictionalProblem, a_tolerated_gap_settles_forces_that_their_law_allows) {
  ContactRows rows;
  for (int k = 0; k < 2; ++k) {
    rows.push_back({{0}, {0}, Eigen::RowVector2d(1, 0), Eigen::RowVector2d(0, 0)});
    rows.push_back({{0}, {0}, Eigen::RowVector2d(0, 1), Eigen::RowVector2d(0, 0)});
  }
  FrictionalProblem problem;
  problem.w = ContactMatrix(rows, {{UnknownBlock(Eigen::Matrix2d::Identity())}});
  problem.b = Eigen::Vector4d(-10, 0, -10 - 1e-6, 0);
  problem.laws = {kBilateral, kBilateral};
  problem.goal = problem.acceptable = 1e-9;
  EXPECT_FALSE(solve(problem, Eigen::Vector4d::Zero()).converged);
  problem.gap_tolerance = 1e-6;
  EXPECT_TRUE(solve(problem, Eigen::Vector4d::Zero()).converged);
  problem.laws = {ForceLaw{0.5}, ForceLaw{0.5}};
  EXPECT_FALSE(is_acceptable(problem, Eigen::Vector4d(15, 0, -5, 0)));
  EXPECT_FALSE(is_acceptable(problem, Eigen::Vector4d(5, 4, 5, -4)));
}

}  // namespace keyblock::active_forces_test
