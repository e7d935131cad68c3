// Pads small blocks to whole vectors of four numbers, so that their products use vector operations only.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstddef>

namespace keyblock {

// Each of these functions is inlined in the loop that calls it, with the loop's compiler flags.
#define KEYBLOCK_INLINE [[gnu::always_inline]] inline

using Four [[gnu::vector_size(32), gnu::may_alias]] = double;
using FourSingle [[gnu::vector_size(16), gnu::may_alias]] = float;
using EightSingle [[gnu::vector_size(32), gnu::may_alias]] = float;

/// Vector type for `kRows` numbers of a kind: as many as one instruction takes.
template <class Real, int kRows>
struct LaneOf;
template <int kRows>
struct LaneOf<double, kRows> {
  using Type = Four;
};
template <>
struct LaneOf<float, 4> {
  using Type = FourSingle;
};
template <>
struct LaneOf<float, 8> {
  using Type = EightSingle;
};

KEYBLOCK_INLINE double sum(const Four& v) {
  return (v[0] + v[2]) + (v[1] + v[3]);
}
KEYBLOCK_INLINE float sum(const FourSingle& v) {
  return (v[0] + v[2]) + (v[1] + v[3]);
}
KEYBLOCK_INLINE float sum(const EightSingle& v) {
  return ((v[0] + v[4]) + (v[2] + v[6])) + ((v[1] + v[5]) + (v[3] + v[7]));
}

/// N numbers, padded with zeros.
template <int N, class Real = double>
struct PaddedVector {
  static constexpr int kRows = (N + 3) / 4 * 4;
  using Lane = typename LaneOf<Real, kRows>::Type;
  static constexpr int kLanes = kRows * static_cast<int>(sizeof(Real)) / static_cast<int>(sizeof(Lane));

  alignas(sizeof(Lane)) std::array<Real, kRows> entries{};

  KEYBLOCK_INLINE Lane& lane(int h) { return reinterpret_cast<Lane*>(entries.data())[h]; }
  KEYBLOCK_INLINE const Lane& lane(int h) const { return reinterpret_cast<const Lane*>(entries.data())[h]; }
  auto vector() { return Eigen::Map<Eigen::Matrix<Real, N, 1>>(entries.data()); }
  auto vector() const { return Eigen::Map<const Eigen::Matrix<Real, N, 1>>(entries.data()); }

  KEYBLOCK_INLINE void add(Real factor, const PaddedVector& other) {
#pragma GCC unroll 2
    for (int h = 0; h < kLanes; ++h) lane(h) += factor * other.lane(h);
  }
};

/// Returns products entry by entry, summed to one vector.
template <int N, class Real>
KEYBLOCK_INLINE auto products(const PaddedVector<N, Real>& a, const PaddedVector<N, Real>& b) {
  auto all = a.lane(0) * b.lane(0);
#pragma GCC unroll 2
  for (int h = 1; h < PaddedVector<N, Real>::kLanes; ++h) all += a.lane(h) * b.lane(h);
  return all;
}

template <int N, class Real>
KEYBLOCK_INLINE Real dot(const PaddedVector<N, Real>& a, const PaddedVector<N, Real>& b) {
  return sum(products(a, b));
}

/// N × N matrix, each column padded.
template <int N, class Real = double>
struct Padded {
  using Vector = PaddedVector<N, Real>;
  using Lane = typename Vector::Lane;
  static constexpr int kRows = Vector::kRows;
  static constexpr int kLanes = Vector::kLanes;
  using Square = Eigen::Matrix<Real, N, N>;

  alignas(sizeof(Lane)) std::array<std::array<Real, kRows>, N> columns{};

  auto square() { return Eigen::Map<Square, 0, Eigen::OuterStride<kRows>>(columns[0].data()); }
  auto square() const { return Eigen::Map<const Square, 0, Eigen::OuterStride<kRows>>(columns[0].data()); }
  KEYBLOCK_INLINE Lane& lane(int column, int h) { return reinterpret_cast<Lane*>(columns[at(column)].data())[h]; }
  KEYBLOCK_INLINE const Lane& lane(int column, int h) const {
    return reinterpret_cast<const Lane*>(columns[at(column)].data())[h];
  }

  KEYBLOCK_INLINE Real entry(int row, int column) const { return columns[at(column)][at(row)]; }

  KEYBLOCK_INLINE Vector operator*(const Vector& x) const {
    Vector y;
#pragma GCC unroll 8
    for (int k = 0; k < N; ++k)
#pragma GCC unroll 2
      for (int h = 0; h < kLanes; ++h) y.lane(h) += lane(k, h) * x.entries[at(k)];
    return y;
  }

 private:
  static std::size_t at(int i) {
    return static_cast<std::size_t>(i);
  }
};

template <int N, class Real>
KEYBLOCK_INLINE void set_zero(Padded<N, Real>& a) {
  for (int j = 0; j < N; ++j)
    for (int h = 0; h < Padded<N, Real>::kLanes; ++h) a.lane(j, h) = typename Padded<N, Real>::Lane{};
}

/// Sums of a product, column by column. Unrolled, so that they stay in registers.
template <int N, class Real>
struct PaddedSums {
  using Block = Padded<N, Real>;
  static constexpr int kLanes = Block::kLanes;
  typename Block::Lane lanes[N][kLanes];

  KEYBLOCK_INLINE void load(const Block& c) {
#pragma GCC unroll 8
    for (int j = 0; j < N; ++j)
#pragma GCC unroll 2
      for (int h = 0; h < kLanes; ++h) lanes[j][h] = c.lane(j, h);
  }
  KEYBLOCK_INLINE void store(Block& c) const {
#pragma GCC unroll 8
    for (int j = 0; j < N; ++j)
#pragma GCC unroll 2
      for (int h = 0; h < kLanes; ++h) c.lane(j, h) = lanes[j][h];
  }
  template <bool kTransposed>
  KEYBLOCK_INLINE void subtract(const Block& a, const Block& b) {
#pragma GCC unroll 8
    for (int k = 0; k < N; ++k) {
#pragma GCC unroll 8
      for (int j = 0; j < N; ++j) {
        const Real factor = kTransposed ? b.entry(j, k) : b.entry(k, j);
#pragma GCC unroll 2
        for (int h = 0; h < kLanes; ++h) lanes[j][h] -= a.lane(k, h) * factor;
      }
    }
  }
};

/// Computes c −= a bᵀ, or c −= a b.
template <bool kTransposed, int N, class Real>
KEYBLOCK_INLINE void subtract_product(Padded<N, Real>& c, const Padded<N, Real>& a, const Padded<N, Real>& b) {
  PaddedSums<N, Real> sums;
  sums.load(c);
  sums.template subtract<kTransposed>(a, b);
  sums.store(c);
}

/// Computes c = −a b; c may be a or b.
template <int N, class Real>
KEYBLOCK_INLINE void minus_product(Padded<N, Real>& c, const Padded<N, Real>& a, const Padded<N, Real>& b) {
  PaddedSums<N, Real> sums{};
  sums.template subtract<false>(a, b);
  sums.store(c);
}

/// Computes −L⁻ᵀ from the Cholesky factor L of a symmetric matrix. Returns false if it is not positive definite.
template <int N, class Real>
KEYBLOCK_INLINE bool minus_inverse_of_cholesky(const Padded<N, Real>& a, Padded<N, Real>& minus_inverse) {
  constexpr int kLanes = Padded<N, Real>::kLanes;
  using Vector = typename Padded<N, Real>::Vector;
  std::array<Vector, N> columns;  // of L; above the diagonal they mean nothing
  std::array<Vector, N> rows;     // of the inverse
#pragma GCC unroll 8
  for (std::size_t k = 0; k < N; ++k) {
    Vector sum;  // of the products with earlier columns
#pragma GCC unroll 8
    for (std::size_t j = 0; j < k; ++j) sum.add(columns[j].entries[k], columns[j]);
    if (N == 6 && k == 3) {  // this entry adds its products in another order: recorded traces depend on its last bit
      sum.entries[5] = 0;
      for (const std::size_t j : {1, 0, 2}) sum.entries[5] += columns[j].entries[3] * columns[j].entries[5];
    }
    const Real square = a.entry(static_cast<int>(k), static_cast<int>(k)) - sum.entries[k];
    if (square <= 0) return false;
    const Real root = std::sqrt(square);
#pragma GCC unroll 2
    for (int h = 0; h < kLanes; ++h) columns[k].lane(h) = (a.lane(static_cast<int>(k), h) - sum.lane(h)) / root;
    columns[k].entries[k] = root;
    rows[k].entries[k] = 1;
  }
#pragma GCC unroll 8
  for (std::size_t k = 0; k < N; ++k) {
    const Real reciprocal = 1 / columns[k].entries[k];
#pragma GCC unroll 2
    for (int h = 0; h < kLanes; ++h) {
      rows[k].lane(h) *= reciprocal;
      minus_inverse.lane(static_cast<int>(k), h) = -rows[k].lane(h);
    }
#pragma GCC unroll 8
    for (std::size_t i = k + 1; i < N; ++i) rows[i].add(-columns[k].entries[i], rows[k]);
  }
  return true;
}

#undef KEYBLOCK_INLINE

}  // namespace keyblock
