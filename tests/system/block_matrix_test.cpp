// Blocks of unequal size are kept once, above the diagonal, and multiply as the full symmetric matrix.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/block_matrix.hpp"

#include <gtest/gtest.h>

#include <random>

namespace keyblock::block_matrix_test {
namespace {

using Block = BlockMatrix::Block;

Block random_block(int rows, int columns, std::mt19937& random) {
  std::uniform_real_distribution<double> value(-1, 1);
  Block block(rows, columns);
  for (double& x : block.reshaped()) x = value(random);
  return block;
}

}  // namespace

TEST(BlockMatrix, multiplies_as_the_full_symmetric_matrix) {
  std::mt19937 random(3);
  for (const std::vector<int>& sizes : {std::vector{6, 2, 3}, {6, 6, 6}, {3, 3, 3}, {0, 6, 3}}) {
    const std::vector<int> first{0, sizes[0], sizes[0] + sizes[1]};
    const int count = first[2] + sizes[2];
    BlockMatrix matrix(sizes);
    Eigen::MatrixXd full = Eigen::MatrixXd::Zero(count, count);
    for (const auto& [i, j] : {std::pair{0, 2}, {2, 0}, {1, 0}, {1, 2}, {0, 2}}) {
      const Block block = random_block(sizes[i], sizes[j], random);
      matrix.add(i, j, block);
      full.block(first[i], first[j], sizes[i], sizes[j]) += block;
      full.block(first[j], first[i], sizes[j], sizes[i]) += block.transpose();
    }
    for (int i = 0; i < 3; ++i) {
      const Block half = random_block(sizes[i], sizes[i], random);
      matrix.add(i, i, half + half.transpose());
      full.block(first[i], first[i], sizes[i], sizes[i]) += half + half.transpose();
    }
    const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(count, -1, 1);
    EXPECT_LT((matrix * x - full * x).norm(), 1e-14 * count);
  }
}

TEST(BlockMatrix, a_row_begins_with_the_diagonal_and_has_its_columns_ascending) {
  BlockMatrix matrix({1, 1, 1, 1});
  for (int j : {3, 1, 2, 1}) matrix.add(0, j, Block::Ones(1, 1));
  matrix.add(3, 1, Block::Ones(1, 1));
  std::vector<int> columns;
  for (const BlockMatrix::Entry& entry : matrix.row(0)) columns.push_back(entry.column);
  EXPECT_EQ(columns, (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(matrix.row(0)[1].block(0, 0), 2) << "added twice";
  EXPECT_EQ(matrix.row(1).back().column, 3) << "kept above the diagonal";
  EXPECT_EQ(matrix.row(3).size(), 1U);
}

TEST(BlockMatrix, rows_of_blocks_follow_one_another) {
  System system({6, 2, 3});
  EXPECT_EQ(system.matrix.block_count(), 3);
  EXPECT_EQ(system.matrix.first_row(2), 8);
  EXPECT_EQ(system.matrix.first_row(3), 11);
  EXPECT_EQ(system.matrix.row_count(), 11);
  system.load_of(1).setConstant(5);
  EXPECT_EQ(system.load.sum(), 10);
  EXPECT_EQ(system.load[6], 5);
  EXPECT_EQ(system.load[7], 5);
}

TEST(BlockMatrix, room_made_beforehand_holds_zeros_and_what_is_added) {
  BlockMatrix matrix({2, 3, 1}, {{0, 2}, {1, 2}});
  EXPECT_EQ(matrix.entry_count(), 5);
  EXPECT_EQ(matrix.row(0)[1].block, Block::Zero(2, 1));
  matrix.add(2, 1, Block::Ones(1, 3));
  EXPECT_EQ(matrix.entry_count(), 5);
  EXPECT_EQ(matrix.row(1)[1].block, Block::Ones(3, 1));
  matrix.add(0, 1, Block::Ones(2, 3));  // not foreseen
  EXPECT_EQ(matrix.entry_count(), 6);
  EXPECT_EQ(matrix.row(0)[1].column, 1);
  EXPECT_EQ(matrix.row(2).front().column, 2);
}

}  // namespace keyblock::block_matrix_test
