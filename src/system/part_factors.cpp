// A part's columns are whole columns of the matrix; see part_factors.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/part_factors.hpp"

#include <algorithm>
#include <utility>

namespace keyblock {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

/// Rows keep their order, so that a column keeps its entries one by one.
Sparse part_of(const Sparse& lower, std::span<const int> functions, std::span<const int> place) {
  const auto size = static_cast<Eigen::Index>(2 * functions.size());
  Sparse part(size, size);
  Eigen::Index count = 0;
  for (const int f : functions) count += lower.outerIndexPtr()[2 * f + 2] - lower.outerIndexPtr()[2 * f];
  part.resizeNonZeros(count);
  int* outer = part.outerIndexPtr();
  int* row = part.innerIndexPtr();
  *outer = 0;
  for (const int f : functions) {
    for (const int column : {2 * f, 2 * f + 1}) {
      for (int k = lower.outerIndexPtr()[column]; k < lower.outerIndexPtr()[column + 1]; ++k) {
        const int global = lower.innerIndexPtr()[k];
        *row++ = 2 * place[static_cast<std::size_t>(global / 2)] + global % 2;
      }
      outer[1] = outer[0] + lower.outerIndexPtr()[column + 1] - lower.outerIndexPtr()[column];
      ++outer;
    }
  }
  part.coeffs().setZero();
  return part;
}

void copy_values(const Sparse& lower, std::span<const int> functions, Sparse& part) {
  double* value = part.valuePtr();
  for (const int f : functions)
    value = std::copy(lower.valuePtr() + lower.outerIndexPtr()[2 * f],
                      lower.valuePtr() + lower.outerIndexPtr()[2 * f + 2], value);
}

}  // namespace

PartFactors::PartFactors(const SparseSystem& system, std::vector<std::vector<int>> parts, Definiteness definiteness)
    : parts_(std::move(parts)) {
  std::vector<int> place(static_cast<std::size_t>(system.lower().cols() / 2));
  for (const std::vector<int>& part : parts_) {
    for (std::size_t i = 0; i < part.size(); ++i) place[static_cast<std::size_t>(part[i])] = static_cast<int>(i);
  }
  for (const std::vector<int>& part : parts_) {
    lower_.push_back(part_of(system.lower(), part, place));
    factors_.emplace_back(lower_.back(), definiteness);
  }
}

void PartFactors::factorise(const SparseSystem& system) {
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    copy_values(system.lower(), parts_[p], lower_[p]);
    factors_[p].factorise(lower_[p]);
  }
}

Eigen::MatrixXd PartFactors::solve(int part, const Eigen::MatrixXd& right) const {
  return factors_[static_cast<std::size_t>(part)].solve(right);
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
