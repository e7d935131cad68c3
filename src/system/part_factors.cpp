// Extracts the columns of each part from the matrix, to which they belong whole; see part_factors.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/part_factors.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include "system/sparse_lu.hpp"

namespace keyblock {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

/// Keeps the order of rows, so that a column keeps the order of its entries.
Sparse part_of(const Sparse& matrix, std::span<const int> functions, std::span<const int> place) {
  const auto size = static_cast<Eigen::Index>(2 * functions.size());
  Sparse part(size, size);
  Eigen::Index count = 0;
  for (const int f : functions) count += matrix.outerIndexPtr()[2 * f + 2] - matrix.outerIndexPtr()[2 * f];
  part.resizeNonZeros(count);
  int* outer = part.outerIndexPtr();
  int* row = part.innerIndexPtr();
  *outer = 0;
  for (const int f : functions) {
    for (const int column : {2 * f, 2 * f + 1}) {
      for (int k = matrix.outerIndexPtr()[column]; k < matrix.outerIndexPtr()[column + 1]; ++k) {
        const int global = matrix.innerIndexPtr()[k];
        *row++ = 2 * place[static_cast<std::size_t>(global / 2)] + global % 2;
      }
      outer[1] = outer[0] + matrix.outerIndexPtr()[column + 1] - matrix.outerIndexPtr()[column];
      ++outer;
    }
  }
  part.coeffs().setZero();
  return part;
}

/// Returns the place of each function in its part.
std::vector<int> places(const Sparse& matrix, const std::vector<std::vector<int>>& parts) {
  std::vector<int> place(static_cast<std::size_t>(matrix.cols() / 2));
  for (const std::vector<int>& part : parts)
    for (std::size_t i = 0; i < part.size(); ++i) place[static_cast<std::size_t>(part[i])] = static_cast<int>(i);
  return place;
}

void copy_values(const Sparse& matrix, std::span<const int> functions, Sparse& part) {
  double* value = part.valuePtr();
  for (const int f : functions)
    value = std::copy(matrix.valuePtr() + matrix.outerIndexPtr()[2 * f],
                      matrix.valuePtr() + matrix.outerIndexPtr()[2 * f + 2], value);
}

}  // namespace

PartFactors::PartFactors(const SparseSystem& system, std::vector<std::vector<int>> parts, Definiteness definiteness) {
  const std::vector<int> place = places(system.lower(), parts);
  for (std::vector<int>& part : parts) {
    Sparse lower = part_of(system.lower(), part, place);
    auto factor = std::make_unique<SparseFactor>(lower, definiteness);
    parts_.push_back({std::move(part), false, std::move(lower), std::move(factor)});
  }
}

PartFactors::PartFactors(const SparseSystem& system, const WholeSystem& whole, std::vector<std::vector<int>> parts,
                         const std::vector<bool>& is_whole, Definiteness definiteness) {
  const std::vector<int> place = places(system.lower(), parts);
  for (std::size_t p = 0; p < parts.size(); ++p) {
    Sparse matrix = part_of(is_whole[p] ? whole.matrix() : system.lower(), parts[p], place);
    std::unique_ptr<LinearFactor> factor;
    if (is_whole[p])
      factor = std::make_unique<SparseLu>(matrix);
    else
      factor = std::make_unique<SparseFactor>(matrix, definiteness);
    parts_.push_back({std::move(parts[p]), is_whole[p], std::move(matrix), std::move(factor)});
  }
}

bool PartFactors::are_symmetric() const {
  return std::ranges::none_of(parts_, &Part::is_whole);
}

void PartFactors::factorise(const SparseSystem& system, const WholeSystem* whole) {
  for (Part& part : parts_) {
    assert(!part.is_whole || whole != nullptr);
    copy_values(part.is_whole ? whole->matrix() : system.lower(), part.functions, part.matrix);
    part.factor->factorise(part.matrix);
  }
}

Eigen::MatrixXd PartFactors::solve(int part, const Eigen::MatrixXd& right) const {
  return parts_[static_cast<std::size_t>(part)].factor->solve(right);
}

Eigen::VectorXd PartFactors::solve(const Eigen::VectorXd& right) const {
  Eigen::VectorXd all(right.size());
  for (int p = 0; p < part_count(); ++p) {
    const Eigen::VectorXd own = solve(p, unknowns_of(functions(p), right));
    Eigen::Index i = 0;
    for (const int f : functions(p)) {
      all.segment<2>(2 * f) = own.segment<2>(2 * i);
      ++i;
    }
  }
  return all;
}

Eigen::VectorXd unknowns_of(std::span<const int> functions, const Eigen::VectorXd& all) {
  Eigen::VectorXd own(static_cast<Eigen::Index>(2 * functions.size()));
  Eigen::Index i = 0;
  for (const int f : functions) {
    own.segment<2>(2 * i) = all.segment<2>(2 * f);
    ++i;
  }
  return own;
}

}  // namespace keyblock
