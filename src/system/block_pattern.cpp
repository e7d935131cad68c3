// Orders by Eigen's minimum degree, and builds columns from neighbours and children.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/block_pattern.hpp"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>

namespace keyblock {
namespace {

std::vector<int> elimination_places(int count, const BlockPattern::Pairs& coupled) {
  std::vector<Eigen::Triplet<char>> entries;
  for (int i = 0; i < count; ++i) entries.emplace_back(i, i, 1);
  for (const auto& [i, j] : coupled) {
    entries.emplace_back(i, j, 1);
    entries.emplace_back(j, i, 1);
  }
  Eigen::SparseMatrix<char> graph(count, count);
  graph.setFromTriplets(entries.begin(), entries.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
  if (count > 0) Eigen::AMDOrdering<int>()(graph, order);
  std::vector<int> places(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k) places[static_cast<std::size_t>(order.indices()[k])] = k;
  return places;
}

void sort_and_unite(std::vector<int>& numbers) {
  std::ranges::sort(numbers);
  numbers.erase(std::ranges::unique(numbers).begin(), numbers.end());
}

}  // namespace

BlockPattern::BlockPattern(int block_count, const Pairs& coupled) : place_(elimination_places(block_count, coupled)) {
  std::vector<std::vector<int>> columns(static_cast<std::size_t>(block_count));
  for (const auto& [i, j] : coupled) {
    const auto [first, last] = std::minmax({place(i), place(j)});
    columns[static_cast<std::size_t>(first)].push_back(last);
  }
  begins_.push_back(0);
  for (std::vector<int>& column : columns) {
    sort_and_unite(column);
    rows_.insert(rows_.end(), column.begin(), column.end());
    begins_.push_back(static_cast<int>(rows_.size()));
    if (column.size() < 2) continue;
    std::vector<int>& parent = columns[static_cast<std::size_t>(column.front())];
    parent.insert(parent.end(), column.begin() + 1, column.end());
    column = {};
  }
}

int BlockPattern::entry(int row, int column) const {
  const auto first = rows_.begin() + begin(column);
  return static_cast<int>(std::lower_bound(first, rows_.begin() + begin(column + 1), row) - rows_.begin());
}

}  // namespace keyblock
