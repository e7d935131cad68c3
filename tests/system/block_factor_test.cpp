// The block factorisation compared with a dense solution, with fill, blocks of several sizes and values that are not
// symmetric.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/block_factor.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <random>

namespace keyblock::block_factor_test {
namespace {

// A wall of `columns` × `rows` blocks, each coupled with the next to the right and above.
struct Wall {
  std::vector<int> sizes;
  BlockPattern::Pairs coupled;
};

Wall wall(int columns, int rows, std::vector<int> sizes_in_turn) {
  Wall made;
  for (int i = 0; i < columns * rows; ++i)
    made.sizes.push_back(sizes_in_turn[static_cast<std::size_t>(i) % sizes_in_turn.size()]);
  for (int i = 0; i < columns * rows; ++i) {
    if (i % columns + 1 < columns) made.coupled.emplace_back(i + 1, i);
    if (i + columns < columns * rows) made.coupled.emplace_back(i, i + columns);
    if (i + columns < columns * rows) made.coupled.emplace_back(i, i + columns);
  }
  return made;
}

struct Random {
  std::mt19937 engine{7};
  std::uniform_real_distribution<double> number{-1, 1};
  BlockFactor::Block block(int rows, int columns) {
    BlockFactor::Block made(rows, columns);
    for (int r = 0; r < rows; ++r)
      for (int c = 0; c < columns; ++c) made(r, c) = number(engine);
    return made;
  }
};

// Largest error of the solution, with diagonal blocks great enough to need no pivoting.
double error_on(const Wall& wall, bool is_symmetric) {
  Random random;
  std::vector<int> first{0};
  for (int size : wall.sizes) first.push_back(first.back() + size);
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(first.back(), first.back());
  const int count = static_cast<int>(wall.sizes.size());
  const MatrixShape shape = is_symmetric ? MatrixShape::symmetric : MatrixShape::general;
  BlockFactor factor(std::make_shared<BlockPattern>(count, wall.coupled), wall.sizes, shape);
  const auto add = [&](int i, int j, const BlockFactor::Block& block, bool goes_in = true) {
    if (goes_in) factor.add(i, j, block);
    dense.block(first[static_cast<std::size_t>(i)], first[static_cast<std::size_t>(j)], block.rows(), block.cols()) +=
        block;
  };
  const auto size = [&](int i) { return wall.sizes[static_cast<std::size_t>(i)]; };
  for (int i = 0; i < count; ++i) {
    const BlockFactor::Block block = random.block(size(i), size(i));
    const BlockFactor::Block great = 20 * BlockFactor::Block::Identity(size(i), size(i));
    add(i, i, is_symmetric ? BlockFactor::Block(great + block + block.transpose()) : BlockFactor::Block(great + block));
  }
  for (const auto& [i, j] : wall.coupled) {
    const BlockFactor::Block block = random.block(size(i), size(j));
    add(i, j, block);
    add(j, i, is_symmetric ? BlockFactor::Block(block.transpose()) : random.block(size(j), size(i)), !is_symmetric);
  }
  Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(first.back(), -1, 2);
  const Eigen::VectorXd b = dense * x;
  std::vector<double> solved(b.begin(), b.end());
  EXPECT_TRUE(factor.factorise());
  factor.solve(solved);
  return (Eigen::Map<Eigen::VectorXd>(solved.data(), x.size()) - x).cwiseAbs().maxCoeff();
}

}  // namespace

TEST(BlockFactor, solves_walls_of_rigid_deformable_and_mixed_blocks) {
  for (const std::vector<int>& sizes : {std::vector{3}, std::vector{6}, std::vector{6, 3, 2}, std::vector{1}})
    for (bool is_symmetric : {true, false}) EXPECT_LE(error_on(wall(9, 7, sizes), is_symmetric), 1e-12);
}

TEST(BlockFactor, a_block_that_nothing_holds_has_no_factor) {
  BlockFactor factor(std::make_shared<BlockPattern>(2, BlockPattern::Pairs{{0, 1}}), {3, 3}, MatrixShape::symmetric);
  factor.add(0, 0, BlockFactor::Block::Identity(3, 3));
  EXPECT_FALSE(factor.factorise());
}

// A chain is eliminated without fill, a ring of n blocks with n − 3 entries more than it has.
TEST(BlockPattern, fills_no_more_than_it_must) {
  BlockPattern::Pairs chain;
  for (int i = 0; i + 1 < 20; ++i) chain.emplace_back(i, i + 1);
  EXPECT_EQ(BlockPattern(20, chain).entry_count(), 19);
  chain.emplace_back(0, 19);
  EXPECT_EQ(BlockPattern(20, chain).entry_count(), 20 + 17);
}

// Two blocks of unit inertia with a spring of 1e9 between them, pulled across it: the direction without the spring
// moves by 1. An inverse of the pivot itself would lose nine digits.
TEST(BlockFactor, keeps_what_is_soft_beside_what_is_stiff) {
  constexpr double kStiffness = 1e9;
  Random random;
  for (const bool is_symmetric : {true, false}) {
    const MatrixShape shape = is_symmetric ? MatrixShape::symmetric : MatrixShape::general;
    BlockFactor factor(std::make_shared<BlockPattern>(2, BlockPattern::Pairs{{0, 1}}), {6, 6}, shape);
    Eigen::Matrix<double, 6, 1> on_first = random.block(6, 1);
    Eigen::Matrix<double, 6, 1> on_second = random.block(6, 1);
    const BlockFactor::Block inertia = BlockFactor::Block::Identity(6, 6);
    factor.add(0, 0, inertia + kStiffness * on_first * on_first.transpose());
    factor.add(1, 1, inertia + kStiffness * on_second * on_second.transpose());
    factor.add(0, 1, kStiffness * on_first * on_second.transpose());
    if (!is_symmetric) factor.add(1, 0, kStiffness * on_second * on_first.transpose());
    ASSERT_TRUE(factor.factorise());
    Eigen::Matrix<double, 12, 1> across = Eigen::Matrix<double, 12, 1>::Ones();
    Eigen::Matrix<double, 12, 1> along;
    along << on_first, on_second;
    across -= along * (along.dot(across) / along.squaredNorm());
    Eigen::Matrix<double, 12, 1> x = across;
    factor.solve({x.data(), 12});
    EXPECT_LT((x - across).norm(), 1e-6);
  }
}

TEST(FactorStore, lends_the_room_of_the_last_factor_to_the_next_of_any_shape_and_none_to_another_pattern) {
  FactorStore store;
  const auto error_of = [&](const Wall& made, MatrixShape shape) {
    auto factor = store.take(made.sizes, made.coupled, shape);
    std::size_t rows = 0;
    for (std::size_t i = 0; i < made.sizes.size(); ++i) {
      const int size = made.sizes[i];
      rows += static_cast<std::size_t>(size);
      factor->add(static_cast<int>(i), static_cast<int>(i), 2.0 * BlockFactor::Block::Identity(size, size));
    }
    EXPECT_TRUE(factor->factorise());
    std::vector<double> x(rows, 1);
    factor->solve(x);
    store.give_back(std::move(factor));
    double error = 0;
    for (const double of : x) error = std::max(error, std::abs(of - 0.5));
    return error;
  };
  const Wall six = wall(3, 2, {6, 3});
  for (const MatrixShape shape : {MatrixShape::symmetric, MatrixShape::general, MatrixShape::symmetric})
    EXPECT_LT(error_of(six, shape), 1e-15);
  EXPECT_LT(error_of(wall(2, 2, {6}), MatrixShape::symmetric), 1e-15);
  // Two at once: the one that comes back after a request for another pattern is not lent again.
  auto of_six = store.take(six.sizes, six.coupled, MatrixShape::symmetric);
  const Wall four = wall(4, 1, {6});
  auto of_four = store.take(four.sizes, four.coupled, MatrixShape::symmetric);
  store.give_back(std::move(of_six));
  EXPECT_LT(error_of(four, MatrixShape::general), 1e-15);
}

}  // namespace keyblock::block_factor_test
