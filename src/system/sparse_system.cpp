// Addresses columns by pairs of rows; see sparse_system.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/sparse_system.hpp"

#include <algorithm>
#include <cassert>

namespace keyblock {
namespace {

/// Returns, per function, the functions of the same groups from itself on, ascending.
std::vector<std::vector<int>> coupled_below(int function_count, const FunctionGroups& groups) {
  std::vector<std::vector<int>> groups_of(static_cast<std::size_t>(function_count));
  for (int g = 0; g < groups.group_count(); ++g) {
    for (const int f : groups.group(g)) groups_of[static_cast<std::size_t>(f)].push_back(g);
  }
  std::vector<std::vector<int>> below(static_cast<std::size_t>(function_count));
  for (int f = 0; f < function_count; ++f) {
    std::vector<int>& column = below[static_cast<std::size_t>(f)];
    column.push_back(f);
    for (const int g : groups_of[static_cast<std::size_t>(f)]) {
      for (const int other : groups.group(g)) {
        if (other > f) column.push_back(other);
      }
    }
    std::sort(column.begin(), column.end());
    column.erase(std::unique(column.begin(), column.end()), column.end());
    column.shrink_to_fit();
  }
  return below;
}

}  // namespace

void FunctionGroups::add(std::span<const int> functions) {
  functions_.insert(functions_.end(), functions.begin(), functions.end());
  first_.push_back(functions_.size());
}

std::span<const int> FunctionGroups::group(int g) const {
  const std::size_t first = first_[static_cast<std::size_t>(g)];
  return std::span(functions_).subspan(first, first_[static_cast<std::size_t>(g) + 1] - first);
}

SparseSystem::SparseSystem(int function_count, const FunctionGroups& groups)
    : lower_(2 * function_count, 2 * function_count),
      load_(Eigen::VectorXd::Zero(2 * function_count)),
      absolute_load_(load_) {
  const std::vector<std::vector<int>> below = coupled_below(function_count, groups);
  Eigen::Index count = 0;
  for (const std::vector<int>& column : below) count += 4 * static_cast<Eigen::Index>(column.size()) - 1;
  lower_.resizeNonZeros(count);
  int* outer = lower_.outerIndexPtr();
  int* row = lower_.innerIndexPtr();
  outer[0] = 0;
  for (const std::vector<int>& column : below) {
    for (const int second : {0, 1}) {
      const int* const begin = row;
      for (const int f : column) {
        if (f != column.front() || second == 0) *row++ = 2 * f;
        *row++ = 2 * f + 1;
      }
      outer[1] = outer[0] + static_cast<int>(row - begin);
      ++outer;
    }
  }
  lower_.coeffs().setZero();
}

void SparseSystem::add_matrix(std::span<const int> functions, const Eigen::MatrixXd& block) {
  const int* outer = lower_.outerIndexPtr();
  const int* inner = lower_.innerIndexPtr();
  double* values = lower_.valuePtr();
  for (std::size_t b = 0; b < functions.size(); ++b) {
    const int column = 2 * functions[b];
    const int* const begin = inner + outer[column];
    const int* const end = inner + outer[column + 1];
    double* const first = values + outer[column];
    double* const second =
        values + outer[column + 1] - 1;  // it has no row 2b, therefore its rows are one place earlier
    const auto j = static_cast<Eigen::Index>(2 * b);
    for (std::size_t a = 0; a < functions.size(); ++a) {
      if (functions[a] < functions[b]) continue;
      const int* const found = std::lower_bound(begin, end, 2 * functions[a]);
      assert(found != end && *found == 2 * functions[a] && "functions of one group couple");
      const auto place = found - begin;
      const auto i = static_cast<Eigen::Index>(2 * a);
      first[place] += block(i, j);
      first[place + 1] += block(i + 1, j);
      if (a != b) second[place] += block(i, j + 1);
      second[place + 1] += block(i + 1, j + 1);
    }
  }
}

void SparseSystem::add_load(std::span<const int> functions, const Eigen::VectorXd& part) {
  for (std::size_t a = 0; a < functions.size(); ++a) {
    const auto of_function = part.segment<2>(static_cast<Eigen::Index>(2 * a));
    load_.segment<2>(2 * functions[a]) += of_function;
    absolute_load_.segment<2>(2 * functions[a]) += of_function.cwiseAbs();
  }
}

void SparseSystem::clear() {
  lower_.coeffs().setZero();
  load_.setZero();
  absolute_load_.setZero();
}

void SparseSystem::add_scaled(double factor, const SparseSystem& other) {
  assert(other.lower_.nonZeros() == lower_.nonZeros() && "both have the same groups");
  lower_.coeffs() += factor * other.lower_.coeffs();
}

void SparseSystem::add_scaled(std::span<const double> factors, const SparseSystem& other) {
  assert(other.lower_.nonZeros() == lower_.nonZeros() && "both have the same groups");
  for (Eigen::Index column = 0; column < lower_.outerSize(); ++column) {
    const int begin = lower_.outerIndexPtr()[column];
    const int count = lower_.outerIndexPtr()[column + 1] - begin;
    lower_.coeffs().segment(begin, count) +=
        factors[static_cast<std::size_t>(column / 2)] * other.lower_.coeffs().segment(begin, count);
  }
}

}  // namespace keyblock
