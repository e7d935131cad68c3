// One kernel for each size of block; vectors are padded as the blocks are.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/block_iterations.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "base/loop.hpp"
#include "system/fours.hpp"

namespace keyblock {

class BlockIterations::Kernel {
 public:
  virtual ~Kernel() = default;
  virtual IterationResult conjugate_gradients(const Eigen::VectorXd& b, const Eigen::VectorXd& start,
                                              const IterationLimits& limits) const = 0;
  virtual IterationResult over_relaxation(const Eigen::VectorXd& b, const Eigen::VectorXd& start, double omega,
                                          const IterationLimits& limits) const = 0;
};

namespace {

constexpr float kFirstShift = 1e-3F;
constexpr float kLastShift = 1;  // a diagonal raised by half and still no factor: the matrix is not positive definite

std::size_t at(int i) {
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
};

// In single precision: it need not be exact, and is read twice in each iteration.
template <int N>
class IncompleteFactor {
 public:
  using Square = Padded<N, float>;
  using Vector = PaddedVector<N, float>;

  // Nothing where a pivot is not positive.
  static std::optional<IncompleteFactor> of(const Rows<N, float>& a, float shift) {
    IncompleteFactor factor;
    factor.lower_.reserve(at(a.count()), (a.columns.size() - at(a.count())) / 2);
    factor.upper_.reserve((a.columns.size() - at(a.count())) / 2);
    factor.inverse_pivots_.reserve(at(a.count()));
    std::vector<int> places(at(a.count()), -1);  // of the columns of the row at hand in `raw`
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
      const Eigen::LLT<typename Square::Square> cholesky(pivot.square());
      if (cholesky.info() != Eigen::Success) return std::nullopt;
      Square inverse;
      inverse.square() = cholesky.solve(Square::Square::Identity());
      factor.inverse_pivots_.push_back(inverse);
    }
    return factor;
  }

  // z becomes (L D Lᵀ)⁻¹ z.
  void solve(std::vector<Vector>& z) const {
    const int count = lower_.count();
    for (int i = 0; i < count; ++i)
      for (int e = lower_.begin[at(i)]; e < lower_.begin[at(i) + 1]; ++e)
        z[at(i)].add(-1, lower_.blocks[at(e)] * z[at(lower_.columns[at(e)])]);
    for (int i = count - 1; i >= 0; --i) z[at(i)] = inverse_pivots_[at(i)] * z[at(i)];
    for (int i = count - 1; i >= 0; --i)
      for (int e = lower_.begin[at(i)]; e < lower_.begin[at(i) + 1]; ++e)
        z[at(lower_.columns[at(e)])].add(-1, upper_[at(e)] * z[at(i)]);
  }

 private:
  void add(int column, const Square& l) {
    Square transposed;
    transposed.square() = l.square().transpose();
    lower_.add(column, l);
    upper_.push_back(transposed);
  }

  Rows<N, float> lower_;
  std::vector<Square> upper_;  ///< the blocks of `lower_`, transposed
  std::vector<Square> inverse_pivots_;
};

template <int N>
class KernelOf : public BlockIterations::Kernel {
 public:
  using Square = Padded<N>;
  using Vector = PaddedVector<N>;
  using Vectors = std::vector<Vector>;

  explicit KernelOf(const BlockMatrix& matrix) {
    const int count = matrix.block_count();
    // Blocks left of the diagonal, row by row: those of earlier rows that reach there, which come in ascending order.
    std::vector<int> left(at(count) + 1, 0);
    for (int i = 0; i < count; ++i)
      for (const auto& entry : matrix.row(i))
        if (entry.column != i) ++left[at(entry.column) + 1];
    std::partial_sum(left.begin(), left.end(), left.begin());
    std::vector<std::pair<int, const BlockMatrix::Block*>> below(at(left.back()));
    std::vector<int> next(left.begin(), left.end() - 1);
    rows_.begin.reserve(at(count) + 1);
    rows_.columns.reserve(at(2 * matrix.entry_count() - count));
    for (int i = 0; i < count; ++i) {
      sizes_.push_back(matrix.size(i));
      first_rows_.push_back(matrix.first_row(i));
      for (int k = left[at(i)]; k < left[at(i) + 1]; ++k) rows_.columns.push_back(below[at(k)].first);
      for (const auto& [column, block] : matrix.row(i)) {
        rows_.columns.push_back(column);
        if (column != i) below[at(next[at(column)]++)] = {i, &block};
      }
      rows_.end_row();
    }
    rows_.blocks.resize(rows_.columns.size());
    for_each_entry(at(count), [&](std::size_t i) {
      std::size_t place = at(rows_.begin[i]);
      for (int k = left[i]; k < left[i + 1]; ++k) rows_.blocks[place++] = padded(below[at(k)].second->transpose());
      const std::size_t diagonal = place;
      for (const auto& entry : matrix.row(static_cast<int>(i))) rows_.blocks[place++] = padded(entry.block);
      rows_.blocks[diagonal].square().diagonal().tail(N - sizes_[i]).setOnes();
    });
    unknowns_ = matrix.row_count();
  }

  IterationResult conjugate_gradients(const Eigen::VectorXd& b, const Eigen::VectorXd& start,
                                      const IterationLimits& limits) const override {
    IterationResult result{start, 0, false};
    const std::optional<IncompleteFactor<N>> factor = incomplete_factor();
    if (!factor) return result;
    const std::size_t count = sizes_.size();
    Vectors x = with_padding(start);
    Vectors r = with_padding(b);
    const double goal = limits.residual * norm(r);
    Vectors q(count);
    multiply(x, q);
    for_each_entry(count, [&](std::size_t i) { r[i].add(-1, q[i]); });
    std::vector<PaddedVector<N, float>> z(count);
    Vectors p(count);
    double before = 0;
    for (double left = norm(r); !(result.converged = left <= goal) && result.iterations < limits.count;) {
      // Of unit size: no number leaves the range of single precision.
      for_each_entry(count, [&](std::size_t i) { z[i].vector() = (r[i].vector() / left).template cast<float>(); });
      factor->solve(z);
      const auto [now] = sums_over<1>(count, [&](std::size_t i) {
        return std::array{left * r[i].vector().dot(z[i].vector().template cast<double>())};
      });
      const double beta = before > 0 ? now / before : 0;
      before = now;
      for_each_entry(count, [&](std::size_t i) {
        p[i].vector() = left * z[i].vector().template cast<double>() + beta * p[i].vector();
      });
      multiply(p, q);
      const double alpha = now / sums_over<1>(count, [&](std::size_t i) { return std::array{dot(p[i], q[i])}; })[0];
      if (!std::isfinite(alpha)) break;
      for_each_entry(count, [&](std::size_t i) {
        x[i].add(alpha, p[i]);
        r[i].add(-alpha, q[i]);
      });
      left = norm(r);
      ++result.iterations;
    }
    result.x = without_padding(x);
    return result;
  }

  IterationResult over_relaxation(const Eigen::VectorXd& b, const Eigen::VectorXd& start, double omega,
                                  const IterationLimits& limits) const override {
    IterationResult result{start, 0, false};
    std::vector<Square> inverse(sizes_.size());
    for (int i = 0; i < rows_.count(); ++i) inverse[at(i)].square() = rows_.blocks[at(diagonal(i))].square().inverse();
    Vectors x = with_padding(start);
    const Vectors right = with_padding(b);
    const double goal = limits.residual * norm(right);
    Vectors product(x.size());
    const auto residual = [&] {
      multiply(x, product);
      for (std::size_t i = 0; i < product.size(); ++i) product[i].add(-1, right[i]);
      return norm(product);
    };
    while (!(result.converged = residual() <= goal) && result.iterations < limits.count) {
      for (int i = 0; i < rows_.count(); ++i) {
        Vector r = right[at(i)];
        r.add(-1, times(i, x));
        x[at(i)].add(omega, inverse[at(i)] * r);
      }
      ++result.iterations;
    }
    result.x = without_padding(x);
    return result;
  }

 private:
  template <class Block>
  static Square padded(const Block& block) {
    Square all;
    if (block.rows() == N && block.cols() == N)
      all.square() = block;
    else
      all.square().topLeftCorner(block.rows(), block.cols()) = block;
    return all;
  }

  std::optional<IncompleteFactor<N>> incomplete_factor() const {
    Rows<N, float> single;
    single.begin = rows_.begin;
    single.columns = rows_.columns;
    single.blocks.resize(rows_.blocks.size());
    // Over the greatest entry, which is on a diagonal: the range of single precision is not that of double.
    double greatest = 0;
    for (int i = 0; i < rows_.count(); ++i)
      greatest = std::max(greatest, rows_.blocks[at(diagonal(i))].square().diagonal().cwiseAbs().maxCoeff());
    if (!(greatest > 0)) return std::nullopt;
    for_each_entry(single.blocks.size(), [&](std::size_t k) {
      single.blocks[k].square() = (rows_.blocks[k].square() / greatest).template cast<float>();
    });
    std::optional<IncompleteFactor<N>> factor = IncompleteFactor<N>::of(single, 0);
    for (float shift = kFirstShift; !factor && shift <= kLastShift; shift *= 2)
      factor = IncompleteFactor<N>::of(single, shift);
    return factor;
  }

  int diagonal(int i) const {
    const auto begin = rows_.columns.begin();
    return static_cast<int>(std::lower_bound(begin + rows_.begin[at(i)], begin + rows_.begin[at(i) + 1], i) - begin);
  }

  // Row i of A x.
  Vector times(int i, const Vectors& x) const {
    Vector sum;
    for (int e = rows_.begin[at(i)]; e < rows_.begin[at(i) + 1]; ++e)
      sum.add(1, rows_.blocks[at(e)] * x[at(rows_.columns[at(e)])]);
    return sum;
  }
  void multiply(const Vectors& x, Vectors& y) const {
    for_each_entry(x.size(), [&](std::size_t i) { y[i] = times(static_cast<int>(i), x); });
  }

  static double norm(const Vectors& x) {
    return std::sqrt(sums_over<1>(x.size(), [&](std::size_t i) { return std::array{dot(x[i], x[i])}; })[0]);
  }

  Vectors with_padding(const Eigen::VectorXd& x) const {
    Vectors all(sizes_.size());
    for_each_entry(all.size(),
                   [&](std::size_t i) { all[i].vector().head(sizes_[i]) = x.segment(first_rows_[i], sizes_[i]); });
    return all;
  }
  Eigen::VectorXd without_padding(const Vectors& all) const {
    Eigen::VectorXd x(unknowns_);
    for_each_entry(all.size(),
                   [&](std::size_t i) { x.segment(first_rows_[i], sizes_[i]) = all[i].vector().head(sizes_[i]); });
    return x;
  }

  Rows<N, double> rows_;
  std::vector<int> sizes_;
  std::vector<int> first_rows_;
  int unknowns_ = 0;
};

}  // namespace

BlockIterations::BlockIterations(const BlockMatrix& matrix) {
  int largest = 0;
  for (int i = 0; i < matrix.block_count(); ++i) largest = std::max(largest, matrix.size(i));
  if (largest <= 2)
    kernel_ = std::make_unique<KernelOf<2>>(matrix);
  else if (largest <= 3)
    kernel_ = std::make_unique<KernelOf<3>>(matrix);
  else
    kernel_ = std::make_unique<KernelOf<kMostBlockRows>>(matrix);
}

BlockIterations::BlockIterations(BlockIterations&&) noexcept = default;
BlockIterations& BlockIterations::operator=(BlockIterations&&) noexcept = default;
BlockIterations::~BlockIterations() = default;

IterationResult BlockIterations::conjugate_gradients(const Eigen::VectorXd& b, const Eigen::VectorXd& start,
                                                     const IterationLimits& limits) const {
  return kernel_->conjugate_gradients(b, start, limits);
}

IterationResult BlockIterations::over_relaxation(const Eigen::VectorXd& b, const Eigen::VectorXd& start, double omega,
                                                 const IterationLimits& limits) const {
  return kernel_->over_relaxation(b, start, omega, limits);
}

}  // namespace keyblock
