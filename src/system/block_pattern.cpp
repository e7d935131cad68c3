// Orders by Eigen's minimum degree, and builds columns from neighbours and children.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/block_pattern.hpp"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>
#include <numeric>
#include <span>
#include <utility>

namespace keyblock {
namespace {

// Returns each pair once, the lower number first, in ascending order.
BlockPattern::Pairs in_order(BlockPattern::Pairs pairs) {
  for (auto& [i, j] : pairs)
    if (i > j) std::swap(i, j);
  if (!std::ranges::is_sorted(pairs)) std::ranges::sort(pairs);
  const auto repeated = std::ranges::unique(pairs);
  pairs.erase(repeated.begin(), repeated.end());
  return pairs;
}

// Returns the symmetric graph with its diagonal. Pairs ascend, so that rows arrive in each column in ascending order:
// first those above the diagonal, then the diagonal, then those below.
Eigen::SparseMatrix<char> graph_of(int count, const BlockPattern::Pairs& coupled) {
  Eigen::SparseMatrix<char> graph(count, count);
  graph.resizeNonZeros(count + 2 * static_cast<Eigen::Index>(coupled.size()));
  std::ranges::fill(std::span(graph.valuePtr(), static_cast<std::size_t>(graph.nonZeros())), char{1});
  int* begins = graph.outerIndexPtr();
  std::fill(begins, begins + count + 1, 0);
  for (int i = 0; i < count; ++i) ++begins[i + 1];
  for (const auto& [i, j] : coupled) ++begins[i + 1], ++begins[j + 1];
  std::partial_sum(begins, begins + count + 1, begins);
  std::vector<int> next(begins, begins + count);
  const auto put = [&](int row, int column) { graph.innerIndexPtr()[next[static_cast<std::size_t>(column)]++] = row; };
  for (const auto& [i, j] : coupled) put(i, j);
  for (int i = 0; i < count; ++i) put(i, i);
  for (const auto& [i, j] : coupled) put(j, i);
  return graph;
}

std::vector<int> elimination_places(int count, const BlockPattern::Pairs& coupled) {
  Eigen::SparseMatrix<char> graph = graph_of(count, in_order(coupled));
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
