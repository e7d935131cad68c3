// Storage of the block matrix: each row keeps its blocks sorted by column.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/block_matrix.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace keyblock {

BlockMatrix::BlockMatrix(std::vector<int> sizes) : sizes_(std::move(sizes)), first_rows_(sizes_.size() + 1, 0) {
  std::partial_sum(sizes_.begin(), sizes_.end(), first_rows_.begin() + 1);
  rows_.resize(sizes_.size());
  for (int i = 0; i < block_count(); ++i) block(i, i);
}

BlockMatrix::Block& BlockMatrix::block(int i, int j) {
  std::vector<Entry>& row = rows_[static_cast<std::size_t>(i)];
  auto entry = std::ranges::lower_bound(row, j, {}, &Entry::column);
  if (entry == row.end() || entry->column != j) entry = row.insert(entry, {j, Block::Zero(size(i), size(j))});
  return entry->block;
}

void BlockMatrix::add(int i, int j, const Block& addend) {
  if (i <= j)
    block(i, j) += addend;
  else
    block(j, i) += addend.transpose();
}

Eigen::VectorXd BlockMatrix::operator*(const Eigen::VectorXd& x) const {
  Eigen::VectorXd y = Eigen::VectorXd::Zero(row_count());
  for (int i = 0; i < block_count(); ++i) {
    for (const auto& [j, block] : row(i)) {
      y.segment(first_row(i), size(i)) += block * x.segment(first_row(j), size(j));
      if (j != i) y.segment(first_row(j), size(j)) += block.transpose() * x.segment(first_row(i), size(i));
    }
  }
  return y;
}

System::System(std::vector<int> sizes) : matrix(std::move(sizes)), load(Eigen::VectorXd::Zero(matrix.row_count())) {}

}  // namespace keyblock
