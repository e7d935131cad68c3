// Addresses columns by pairs of rows; see whole_system.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/whole_system.hpp"

#include <algorithm>
#include <cassert>

namespace keyblock {
namespace {

/// Returns, per function, the functions coupled with it, itself included, ascending.
std::vector<std::vector<int>> coupled(int function_count, const FunctionGroups& groups) {
  std::vector<std::vector<int>> lists(static_cast<std::size_t>(function_count));
  for (int f = 0; f < function_count; ++f) lists[static_cast<std::size_t>(f)].push_back(f);
  for (int g = 0; g < groups.group_count(); ++g)
    for (const int f : groups.group(g)) {
      std::vector<int>& list = lists[static_cast<std::size_t>(f)];
      list.insert(list.end(), groups.group(g).begin(), groups.group(g).end());
    }
  for (std::vector<int>& list : lists) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return lists;
}

}  // namespace

WholeSystem::WholeSystem(int function_count, const FunctionGroups& groups)
    : matrix_(2 * function_count, 2 * function_count) {
  const std::vector<std::vector<int>> lists = coupled(function_count, groups);
  Eigen::Index count = 0;
  for (const std::vector<int>& list : lists) count += 4 * static_cast<Eigen::Index>(list.size());
  matrix_.resizeNonZeros(count);
  int* outer = matrix_.outerIndexPtr();
  int* row = matrix_.innerIndexPtr();
  outer[0] = 0;
  for (const std::vector<int>& list : lists)
    for (int second = 0; second < 2; ++second) {
      for (const int f : list) {
        *row++ = 2 * f;
        *row++ = 2 * f + 1;
      }
      outer[1] = outer[0] + 2 * static_cast<int>(list.size());
      ++outer;
    }
  matrix_.coeffs().setZero();
}

// Column by column, the mirrored entries of a column come before its own: rows ascend.
WholeSystem::WholeSystem(const SparseSystem& symmetric) : matrix_(symmetric.lower().selfadjointView<Eigen::Lower>()) {}

double* WholeSystem::at(int row, int column) {
  const int* const inner = matrix_.innerIndexPtr();
  const int* const begin = inner + matrix_.outerIndexPtr()[column];
  const int* const end = inner + matrix_.outerIndexPtr()[column + 1];
  const int* const found = std::lower_bound(begin, end, row);
  assert(found != end && *found == row && "functions of one group couple");
  return matrix_.valuePtr() + (found - inner);
}

void WholeSystem::add_matrix(std::span<const int> functions, const Eigen::MatrixXd& block) {
  for (std::size_t b = 0; b < functions.size(); ++b)
    for (std::size_t a = 0; a < functions.size(); ++a)
      for (int second = 0; second < 2; ++second) {
        double* const place = at(2 * functions[a], 2 * functions[b] + second);
        const auto i = static_cast<Eigen::Index>(2 * a);
        const auto j = static_cast<Eigen::Index>(2 * b) + second;
        place[0] += block(i, j);
        place[1] += block(i + 1, j);
      }
}

void WholeSystem::add(const SparseSystem& symmetric) {
  const Eigen::SparseMatrix<double>& lower = symmetric.lower();
  for (int column = 0; column < static_cast<int>(lower.outerSize()); ++column)
    for (Eigen::SparseMatrix<double>::InnerIterator entry(lower, column); entry; ++entry) {
      const int row = static_cast<int>(entry.row());
      *at(row, column) += entry.value();
      if (row != column) *at(column, row) += entry.value();
    }
}

}  // namespace keyblock
