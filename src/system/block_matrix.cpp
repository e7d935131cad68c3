// Stores the block matrix row after row, each with its blocks sorted by column.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/block_matrix.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <utility>

namespace keyblock {

BlockMatrix::BlockMatrix(std::vector<int> sizes, const Pairs& coupled)
    : sizes_(std::move(sizes)), first_rows_(sizes_.size() + 1, 0) {
  std::partial_sum(sizes_.begin(), sizes_.end(), first_rows_.begin() + 1);
  assert(std::ranges::is_sorted(coupled) && std::ranges::adjacent_find(coupled) == coupled.end());
  assert(std::ranges::all_of(coupled, [](const auto& pair) { return pair.first < pair.second; }));
  entries_.reserve(sizes_.size() + coupled.size());
  auto next = coupled.begin();
  for (int i = 0; i < block_count(); ++i) {
    begins_.push_back(entries_.size());
    entries_.push_back({i, Block::Zero(size(i), size(i))});
    for (; next != coupled.end() && next->first == i; ++next)
      entries_.push_back({next->second, Block::Zero(size(i), size(next->second))});
  }
  begins_.push_back(entries_.size());
}

BlockMatrix::Block& BlockMatrix::block(int i, int j) {
  const auto row = static_cast<std::size_t>(i);
  if (i == j) return entries_[begins_[row]].block;
  const auto end = entries_.begin() + static_cast<std::ptrdiff_t>(begins_[row + 1]);
  auto entry = std::lower_bound(entries_.begin() + static_cast<std::ptrdiff_t>(begins_[row]), end, j,
                                [](const Entry& e, int column) { return e.column < column; });
  if (entry == end || entry->column != j) {
    entry = entries_.insert(entry, {j, Block::Zero(size(i), size(j))});
    for (std::size_t after = row + 1; after < begins_.size(); ++after) ++begins_[after];
  }
  return entry->block;
}

void BlockMatrix::add(int i, int j, const Block& addend) {
  if (i <= j)
    block(i, j) += addend;
  else
    block(j, i) += addend.transpose();
}

namespace {

// Adds to y the products of the blocks of row i, which are all N × N.
template <int N>
void add_row(const BlockMatrix& a, int i, const Eigen::VectorXd& x, Eigen::VectorXd& y) {
  using Square = Eigen::Map<const Eigen::Matrix<double, N, N>>;
  const Eigen::Matrix<double, N, 1> xi = x.segment<N>(a.first_row(i));
  Eigen::Matrix<double, N, 1> sum = y.segment<N>(a.first_row(i));
  for (const auto& [j, block] : a.row(i)) {
    const Square square(block.data());
    sum.noalias() += square * x.segment<N>(a.first_row(j));
    if (j != i) y.segment<N>(a.first_row(j)).noalias() += square.transpose() * xi;
  }
  y.segment<N>(a.first_row(i)) = sum;
}

void add_row_of_any_size(const BlockMatrix& a, int i, const Eigen::VectorXd& x, Eigen::VectorXd& y) {
  for (const auto& [j, block] : a.row(i)) {
    y.segment(a.first_row(i), a.size(i)) += block * x.segment(a.first_row(j), a.size(j));
    if (j != i) y.segment(a.first_row(j), a.size(j)) += block.transpose() * x.segment(a.first_row(i), a.size(i));
  }
}

}  // namespace

Eigen::VectorXd BlockMatrix::operator*(const Eigen::VectorXd& x) const {
  Eigen::VectorXd y = Eigen::VectorXd::Zero(row_count());
  const auto all_have = [&](int rows) { return std::ranges::all_of(sizes_, [rows](int s) { return s == rows; }); };
  const auto add = all_have(6) ? add_row<6> : all_have(3) ? add_row<3> : add_row_of_any_size;
  for (int i = 0; i < block_count(); ++i) add(*this, i, x, y);
  return y;
}

System::System(std::vector<int> sizes, const BlockMatrix::Pairs& coupled)
    : matrix(std::move(sizes), coupled), load(Eigen::VectorXd::Zero(matrix.row_count())) {}

}  // namespace keyblock
