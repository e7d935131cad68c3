// Defines the rows of a block matrix padded to one block size, and their incomplete factorisation.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "base/loop.hpp"
#include "system/fours.hpp"

namespace keyblock::padded_rows {

inline constexpr float kFirstShift = 1e-3F;
inline constexpr float kLastShift =
    1;  // the matrix is not positive definite if a shift up to this one gives no factorisation

inline std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

// Blocks of row i: from begin[i] up to begin[i + 1], columns ascending.
template <int N, class Real>
struct Rows {
  using Square = Padded<N, Real>;
  std::vector<int> begin{0};
  std::vector<int> columns;
  std::vector<Square> blocks;

  int count() const { return static_cast<int>(begin.size()) - 1; }
  void reserve(std::size_t row_count, std::size_t entry_count) {
    begin.reserve(row_count + 1);
    columns.reserve(entry_count);
    blocks.reserve(entry_count);
  }
  void end_row() { begin.push_back(static_cast<int>(columns.size())); }
  void add(int column, const Square& block) {
    columns.push_back(column);
    blocks.push_back(block);
  }
  int diagonal(int i) const {
    const auto first = columns.begin();
    return static_cast<int>(std::lower_bound(first + begin[at(i)], first + begin[at(i) + 1], i) - first);
  }
  // Returns row i of A x.
  PaddedVector<N, Real> times(int i, const std::vector<PaddedVector<N, Real>>& x) const {
    PaddedVector<N, Real> sum;
    for (int e = begin[at(i)]; e < begin[at(i) + 1]; ++e) sum.add(1, blocks[at(e)] * x[at(columns[at(e)])]);
    return sum;
  }
};

// Returns the entries over `scale`; smaller blocks are padded with ones on the diagonal.
template <int N, class Real, class Block>
Padded<N, Real> padded(const Block& block, double scale) {
  Padded<N, Real> all;
  if (block.rows() == N && block.cols() == N)
    all.square() = (block.template topLeftCorner<N, N>() / scale).template cast<Real>();
  else
    all.square().topLeftCorner(block.rows(), block.cols()) = (block / scale).template cast<Real>();
  return all;
}

// Returns the matrix with both of its halves, over `scale`.
template <int N, class Real>
Rows<N, Real> full_rows(const BlockMatrix& matrix, double scale) {
  Rows<N, Real> rows;
  const int count = matrix.block_count();
  // Blocks left of the diagonal, row by row, come from the earlier rows that reach there, in ascending order.
  std::vector<int> left(at(count) + 1, 0);
  for (int i = 0; i < count; ++i)
    for (const auto& entry : matrix.row(i))
      if (entry.column != i) ++left[at(entry.column) + 1];
  std::partial_sum(left.begin(), left.end(), left.begin());
  std::vector<std::pair<int, const BlockMatrix::Block*>> below(at(left.back()));
  std::vector<int> next(left.begin(), left.end() - 1);
  rows.begin.reserve(at(count) + 1);
  rows.columns.reserve(at(2 * matrix.entry_count() - count));
  for (int i = 0; i < count; ++i) {
    for (int k = left[at(i)]; k < left[at(i) + 1]; ++k) rows.columns.push_back(below[at(k)].first);
    for (const auto& [column, block] : matrix.row(i)) {
      rows.columns.push_back(column);
      if (column != i) below[at(next[at(column)]++)] = {i, &block};
    }
    rows.end_row();
  }
  rows.blocks.resize(rows.columns.size());
  for_each_entry(at(count), [&](std::size_t i) {
    std::size_t place = at(rows.begin[i]);
    for (int k = left[i]; k < left[i + 1]; ++k)
      rows.blocks[place++] = padded<N, Real>(below[at(k)].second->transpose(), scale);
    const std::size_t diagonal = place;
    for (const auto& entry : matrix.row(static_cast<int>(i)))
      rows.blocks[place++] = padded<N, Real>(entry.block, scale);
    rows.blocks[diagonal].square().diagonal().tail(N - matrix.size(static_cast<int>(i))).setOnes();
  });
  return rows;
}

template <int N, class Real>
std::vector<PaddedVector<N, Real>> with_padding(const BlockMatrix& matrix, const Eigen::VectorXd& x) {
  std::vector<PaddedVector<N, Real>> all(at(matrix.block_count()));
  for (int i = 0; i < matrix.block_count(); ++i)
    all[at(i)].vector().head(matrix.size(i)) = x.segment(matrix.first_row(i), matrix.size(i)).template cast<Real>();
  return all;
}

template <int N, class Real>
Eigen::VectorXd without_padding(const BlockMatrix& matrix, const std::vector<PaddedVector<N, Real>>& all) {
  Eigen::VectorXd x(matrix.row_count());
  for (int i = 0; i < matrix.block_count(); ++i)
    x.segment(matrix.first_row(i), matrix.size(i)) = all[at(i)].vector().head(matrix.size(i)).template cast<double>();
  return x;
}

// Incomplete factorisation in single precision: it need not be exact, and is read twice in each iteration.
template <int N>
class IncompleteFactor {
 public:
  using Square = Padded<N, float>;
  using Vector = PaddedVector<N, float>;

  // Returns nothing if a pivot is not positive.
  static std::optional<IncompleteFactor> of(const Rows<N, float>& a, float shift) {
    IncompleteFactor factor;
    factor.lower_.reserve(at(a.count()), (a.columns.size() - at(a.count())) / 2);
    factor.upper_.reserve((a.columns.size() - at(a.count())) / 2);
    factor.inverse_pivots_.reserve(at(a.count()));
    std::vector<int> places(at(a.count()), -1);  // of the columns of the present row in `raw`
    std::vector<Square> raw;                     // − L_ij D_j of that row
    for (int i = 0; i < a.count(); ++i) {
      raw.clear();
      const int first = a.begin[at(i)];
      int entry = first;
      while (a.columns[at(entry)] < i) ++entry;
      Square pivot = a.blocks[at(entry)];
      pivot.square().diagonal() *= 1 + shift;
      for (int e = first; e < entry; ++e) {
        const int j = a.columns[at(e)];
        Square sum = a.blocks[at(e)];
        for (int k = factor.lower_.begin[at(j)]; k < factor.lower_.begin[at(j) + 1]; ++k)
          if (const int place = places[at(factor.lower_.columns[at(k)])]; place >= 0)
            subtract_product<true>(sum, raw[at(place)], factor.lower_.blocks[at(k)]);
        places[at(j)] = static_cast<int>(raw.size());
        raw.push_back(sum);
        Square l;
        subtract_product<false>(l, sum, factor.inverse_pivots_[at(j)]);
        l.square() *= -1;
        subtract_product<true>(pivot, sum, l);
        factor.add(j, l);
      }
      factor.lower_.end_row();
      for (int e = first; e < entry; ++e) places[at(a.columns[at(e)])] = -1;
      const std::optional<Square> inverse = inverse_by_cholesky(pivot);
      if (!inverse) return std::nullopt;
      factor.inverse_pivots_.push_back(*inverse);
    }
    return factor;
  }

  // Sets z to (L D Lᵀ)⁻¹ r; returns r · z.
  double solve(const std::vector<Vector>& r, std::vector<Vector>& z) const {
    const int count = lower_.count();
    for (int i = 0; i < count; ++i) {
      Vector sum = r[at(i)];
      for (int e = lower_.begin[at(i)]; e < lower_.begin[at(i) + 1]; ++e)
        sum.add(-1, lower_.blocks[at(e)] * z[at(lower_.columns[at(e)])]);
      z[at(i)] = sum;
    }
    for (int i = count - 1; i >= 0; --i) z[at(i)] = inverse_pivots_[at(i)] * z[at(i)];
    double product = 0;
    for (int i = count - 1; i >= 0; --i) {
      const Vector own = z[at(i)];
      product += static_cast<double>(dot(r[at(i)], own));
      for (int e = lower_.begin[at(i)]; e < lower_.begin[at(i) + 1]; ++e)
        z[at(lower_.columns[at(e)])].add(-1, upper_[at(e)] * own);
    }
    return product;
  }

 private:
  void add(int column, const Square& l) {
    Square transposed;
    transposed.square() = l.square().transpose();
    lower_.add(column, l);
    upper_.push_back(transposed);
  }

  // Returns the inverse of a symmetric block, or nothing if it is not positive definite. Written out for a fixed size,
  // because Eigen's triangular solves took half the time of the whole incomplete factorisation.
  static std::optional<Square> inverse_by_cholesky(const Square& block) {
    float l[N][N] = {};  // the Cholesky factor, 1 / l_ii on its diagonal
    float m[N][N] = {};  // its inverse
    for (int j = 0; j < N; ++j) {
      float pivot = block.entry(j, j);
      for (int k = 0; k < j; ++k) pivot -= l[j][k] * l[j][k];
      if (!(pivot > 0)) return std::nullopt;
      l[j][j] = 1 / std::sqrt(pivot);
      for (int i = j + 1; i < N; ++i) {
        float sum = block.entry(i, j);
        for (int k = 0; k < j; ++k) sum -= l[i][k] * l[j][k];
        l[i][j] = sum * l[j][j];
      }
    }
    for (int j = 0; j < N; ++j) {
      m[j][j] = l[j][j];
      for (int i = j + 1; i < N; ++i) {
        float sum = 0;
        for (int k = j; k < i; ++k) sum -= l[i][k] * m[k][j];
        m[i][j] = sum * l[i][i];
      }
    }
    Square inverse;
    for (int j = 0; j < N; ++j)
      for (int i = 0; i < N; ++i) {
        float sum = 0;
        for (int k = std::max(i, j); k < N; ++k) sum += m[k][i] * m[k][j];
        inverse.square()(i, j) = sum;
      }
    return inverse;
  }

  Rows<N, float> lower_;
  std::vector<Square> upper_;  ///< the blocks of `lower_`, transposed
  std::vector<Square> inverse_pivots_;
};

template <int N>
std::optional<IncompleteFactor<N>> incomplete_factor(const Rows<N, float>& rows) {
  std::optional<IncompleteFactor<N>> factor = IncompleteFactor<N>::of(rows, 0);
  for (float shift = kFirstShift; !factor && shift <= kLastShift; shift *= 2)
    factor = IncompleteFactor<N>::of(rows, shift);
  return factor;
}

}  // namespace keyblock::padded_rows
