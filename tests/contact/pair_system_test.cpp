// Iterations on random blocks and contacts compared with a dense factorisation.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/solve/pair_system.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <random>

namespace keyblock::pair_system_test {
namespace {

/// Blocks of 6 and of 3 unknowns and one fixed block, each in contact with the next and one farther on.
struct RandomPairs {
  ContactRows rows;
  Table<ElementIndex, UnknownBlock> flexibility;
  std::vector<PairStiffness> h;

  /// `unit`: of A; `most`: unknowns of the larger blocks.
  RandomPairs(int elements, unsigned seed, double unit = 1, int most = 6) : unit_(unit), dice_(seed) {
    for (int e = 0; e < elements; ++e) {
      const int size = e == 0 ? 0 : e % 3 == 0 ? 3 : most;
      const Eigen::MatrixXd a = random(size, size);
      flexibility.push_back(UnknownBlock((a * a.transpose() + Eigen::MatrixXd::Identity(size, size)) / unit));
    }
    for (int e = 0; e + 1 < elements; ++e)
      for (const int other : {e + 1, e + 7})
        if (other < elements) add_pair({e}, {other});
  }

  /// G, one column per unknown of a moving block.
  Eigen::MatrixXd g(const BlockNumbers& blocks) const {
    Eigen::MatrixXd all = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(rows.size()), blocks.row_count());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const auto put = [&](ElementIndex e, const ContactRow::Row& row) {
        if (const int block = blocks.of(e); block >= 0)
          all.row(static_cast<Eigen::Index>(i)).segment(blocks.first_row(block), blocks.size(block)) = row;
      };
      put(rows[i].vertex_element, rows[i].of_vertex);
      put(rows[i].edge_element, rows[i].of_edge);
    }
    return all;
  }
  Eigen::MatrixXd stiffness(const BlockNumbers& blocks) const {
    Eigen::MatrixXd all = Eigen::MatrixXd::Zero(blocks.row_count(), blocks.row_count());
    for (int i = 0; i < blocks.count(); ++i)
      all.block(blocks.first_row(i), blocks.first_row(i), blocks.size(i), blocks.size(i)) = blocks.stiffness(i);
    return all;
  }
  Eigen::MatrixXd springs() const {
    const auto count = static_cast<Eigen::Index>(rows.size());
    Eigen::MatrixXd all = Eigen::MatrixXd::Zero(count, count);
    for (std::size_t i = 0; i < h.size(); ++i) {
      const auto n = static_cast<Eigen::Index>(2 * i);
      all(n, n) = h[i].nn;
      all(n + 1, n) = h[i].tn;
      all(n + 1, n + 1) = h[i].tt;
    }
    return all;
  }
  Eigen::MatrixXd random(int rows_count, int columns) {
    return Eigen::MatrixXd::NullaryExpr(rows_count, columns, [&] { return uniform_(dice_); });
  }

 private:
  void add_pair(ElementIndex a, ElementIndex b) {
    const auto size = [&](ElementIndex e) { return static_cast<int>(flexibility[e].rows()); };
    for (int k = 0; k < 2; ++k) rows.push_back({a, b, random(1, size(a)), random(1, size(b))});
    const bool slips = h.size() % 4 == 1;
    const bool is_open = h.size() % 5 == 2;
    if (is_open)
      h.push_back({});
    else
      h.push_back({0.5 * unit_, slips ? 0.3 * unit_ : 0, slips ? 0 : 0.2 * unit_});
  }

  double unit_;
  std::mt19937 dice_;
  std::uniform_real_distribution<double> uniform_{-1, 1};
};

}  // namespace

TEST(PairSystem, iterations_meet_the_dense_solution_with_slip_and_open_pairs) {
  RandomPairs scene(120, 5);
  const BlockNumbers blocks(scene.rows, {scene.flexibility});
  const PairSystem system(scene.rows, blocks, scene.flexibility);
  const Eigen::MatrixXd g = scene.g(blocks);
  const Eigen::VectorXd f = scene.random(static_cast<int>(scene.rows.size()), 1);
  const Eigen::MatrixXd all = scene.stiffness(blocks) + g.transpose() * scene.springs() * g;
  const Eigen::VectorXd exact = g * all.partialPivLu().solve(g.transpose() * f);
  const auto result = system.solve(scene.h, f, Eigen::VectorXd::Zero(f.size()), 1e-10, 1000);
  EXPECT_TRUE(result.converged);
  EXPECT_LE((result.rates - exact).norm(), 1e-8 * exact.norm());
  // From the forces of the solution no iteration is needed: A x = Gᵀ (f − H G x).
  const Eigen::VectorXd start = f - scene.springs() * exact;
  EXPECT_EQ(system.solve(scene.h, f, start, 1e-7, 1000).products, 1);
  EXPECT_LE((system.answer(f) - g * scene.stiffness(blocks).inverse() * g.transpose() * f).norm(), 1e-9 * f.norm());
}

// If nothing slips the matrix is symmetric, and another iteration is used.
TEST(PairSystem, iterations_meet_the_dense_solution_where_all_pairs_stick) {
  RandomPairs scene(120, 9);
  for (PairStiffness& of : scene.h) of.tn = 0;
  const BlockNumbers blocks(scene.rows, {scene.flexibility});
  const PairSystem system(scene.rows, blocks, scene.flexibility);
  const Eigen::MatrixXd g = scene.g(blocks);
  const Eigen::VectorXd f = scene.random(static_cast<int>(scene.rows.size()), 1);
  const Eigen::MatrixXd all = scene.stiffness(blocks) + g.transpose() * scene.springs() * g;
  const auto result = system.solve(scene.h, f, Eigen::VectorXd::Zero(f.size()), 1e-10, 1000);
  EXPECT_TRUE(result.converged);
  const Eigen::VectorXd exact = g * all.partialPivLu().solve(g.transpose() * f);
  EXPECT_LE((result.rates - exact).norm(), 1e-8 * exact.norm());
}

TEST(PairSystem, single_precision_bears_any_unit_and_blocks_of_three_unknowns) {
  for (const int most : {3, 6})
    for (const double unit : {1e-25, 1e-13, 1e13, 1e25}) {
      RandomPairs scene(120, 7, unit, most);
      const BlockNumbers blocks(scene.rows, {scene.flexibility});
      const PairSystem system(scene.rows, blocks, scene.flexibility);
      const Eigen::VectorXd f = scene.random(static_cast<int>(scene.rows.size()), 1);
      const double goal = 1e-9 / std::sqrt(unit);
      const auto result = system.solve(scene.h, f, Eigen::VectorXd::Zero(f.size()), goal, 1000);
      EXPECT_TRUE(result.converged) << most << ' ' << unit;
    }
}

TEST(PairSystem, what_is_no_number_does_not_converge) {
  RandomPairs scene(120, 8);
  const BlockNumbers blocks(scene.rows, {scene.flexibility});
  const PairSystem system(scene.rows, blocks, scene.flexibility);
  Eigen::VectorXd f = scene.random(static_cast<int>(scene.rows.size()), 1);
  f[5] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(system.solve(scene.h, f, Eigen::VectorXd::Zero(f.size()), 1e-3, 1000).converged);
}

TEST(PairSystem, too_few_products_are_said_to_be_too_few) {
  RandomPairs scene(120, 6);
  const BlockNumbers blocks(scene.rows, {scene.flexibility});
  const PairSystem system(scene.rows, blocks, scene.flexibility);
  const Eigen::VectorXd f = scene.random(static_cast<int>(scene.rows.size()), 1);
  EXPECT_FALSE(system.solve(scene.h, f, Eigen::VectorXd::Zero(f.size()), 1e-10, 4).converged);
}

}  // namespace keyblock::pair_system_test
