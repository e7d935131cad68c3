// One kernel for each size of block; vectors are padded as the blocks are.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/block_iterations.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

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

constexpr double kFirstShift = 1e-3;
constexpr double kLastShift = 1;  // a diagonal raised by half and still no factor: the matrix is not positive definite

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

template <int N>
using SquareOf = Eigen::Matrix<double, N, N>;

// Blocks of row i: from begin[i] up to begin[i + 1], columns ascending.
template <int N>
struct Rows {
  std::vector<int> begin{0};
  std::vector<int> columns;
  std::vector<SquareOf<N>> blocks;

  int count() const { return static_cast<int>(begin.size()) - 1; }
  void reserve(std::size_t row_count, std::size_t entry_count) {
    begin.reserve(row_count + 1);
    columns.reserve(entry_count);
    blocks.reserve(entry_count);
  }
  void end_row() { begin.push_back(static_cast<int>(columns.size())); }
  void add(int column, const SquareOf<N>& block) {
    columns.push_back(column);
    blocks.push_back(block);
  }
};

template <int N>
class IncompleteFactor {
 public:
  using Square = SquareOf<N>;

  // Nothing where a pivot is not positive.
  static std::optional<IncompleteFactor> of(const Rows<N>& a, double shift) {
    IncompleteFactor factor;
    factor.lower_.reserve(at(a.count()), (a.columns.size() - at(a.count())) / 2);
    factor.inverse_pivots_.reserve(at(a.count()));
    std::vector<int> places(at(a.count()), -1);  // of the columns of the row at hand in `raw`
    std::vector<Square> raw;                     // L_ij D_j of that row
    for (int i = 0; i < a.count(); ++i) {
      raw.clear();
      Square pivot = Square::Zero();
      const int first = a.begin[at(i)];
      int entry = first;
      for (; a.columns[at(entry)] < i; ++entry) {
        const int j = a.columns[at(entry)];
        Square sum = a.blocks[at(entry)];
        for (int k = factor.lower_.begin[at(j)]; k < factor.lower_.begin[at(j) + 1]; ++k)
          if (const int place = places[at(factor.lower_.columns[at(k)])]; place >= 0)
            sum.noalias() -= raw[at(place)] * factor.lower_.blocks[at(k)].transpose();
        places[at(j)] = static_cast<int>(raw.size());
        raw.push_back(sum);
        const Square l = sum * factor.inverse_pivots_[at(j)];
        pivot.noalias() -= sum * l.transpose();
        factor.lower_.add(j, l);
      }
      factor.lower_.end_row();
      pivot += a.blocks[at(entry)];
      pivot.diagonal() += shift * a.blocks[at(entry)].diagonal();
      for (int e = first; e < entry; ++e) places[at(a.columns[at(e)])] = -1;
      const Eigen::LLT<Square> cholesky(pivot);
      if (cholesky.info() != Eigen::Success) return std::nullopt;
      factor.inverse_pivots_.push_back(cholesky.solve(Square::Identity()));
    }
    return factor;
  }

  // z = (L D Lᵀ)⁻¹ r.
  void solve(const Eigen::VectorXd& r, Eigen::VectorXd& z) const {
    z = r;
    const int count = lower_.count();
    for (int i = 0; i < count; ++i)
      for (int e = lower_.begin[at(i)]; e < lower_.begin[at(i) + 1]; ++e)
        z.template segment<N>(N * i).noalias() -=
            lower_.blocks[at(e)] * z.template segment<N>(N * lower_.columns[at(e)]);
    for (int i = count - 1; i >= 0; --i) {
      const Eigen::Matrix<double, N, 1> own = z.template segment<N>(N * i);
      z.template segment<N>(N * i) = inverse_pivots_[at(i)] * own;
    }
    for (int i = count - 1; i >= 0; --i)
      for (int e = lower_.begin[at(i)]; e < lower_.begin[at(i) + 1]; ++e)
        z.template segment<N>(N * lower_.columns[at(e)]).noalias() -=
            lower_.blocks[at(e)].transpose() * z.template segment<N>(N * i);
  }

 private:
  Rows<N> lower_;
  std::vector<Square> inverse_pivots_;
};

template <int N>
class KernelOf : public BlockIterations::Kernel {
 public:
  using Square = SquareOf<N>;

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
    rows_.reserve(at(count), at(2 * matrix.entry_count() - count));
    for (int i = 0; i < count; ++i) {
      sizes_.push_back(matrix.size(i));
      first_rows_.push_back(matrix.first_row(i));
      for (int k = left[at(i)]; k < left[at(i) + 1]; ++k)
        rows_.add(below[at(k)].first, padded(below[at(k)].second->transpose()));
      for (const auto& [column, block] : matrix.row(i)) {
        rows_.add(column, padded(block));
        if (column == i)
          rows_.blocks.back().diagonal().tail(N - block.rows()).setOnes();
        else
          below[at(next[at(column)]++)] = {i, &block};
      }
      rows_.end_row();
    }
    unknowns_ = matrix.row_count();
  }

  IterationResult conjugate_gradients(const Eigen::VectorXd& b, const Eigen::VectorXd& start,
                                      const IterationLimits& limits) const override {
    IterationResult result{start, 0, false};
    std::optional<IncompleteFactor<N>> factor = IncompleteFactor<N>::of(rows_, 0);
    for (double shift = kFirstShift; !factor && shift <= kLastShift; shift *= 2)
      factor = IncompleteFactor<N>::of(rows_, shift);
    if (!factor) return result;
    Eigen::VectorXd x = with_padding(start);
    Eigen::VectorXd r = with_padding(b);
    const double goal = limits.residual * r.norm();
    Eigen::VectorXd q(x.size());
    multiply(x, q);
    r -= q;
    Eigen::VectorXd z(x.size());
    Eigen::VectorXd p;
    double before = 0;
    while (!(result.converged = r.norm() <= goal) && result.iterations < limits.count) {
      factor->solve(r, z);
      const double now = r.dot(z);
      if (p.size() == 0)
        p = z;
      else
        p = z + now / before * p;
      before = now;
      multiply(p, q);
      const double alpha = now / p.dot(q);
      if (!std::isfinite(alpha)) break;
      x += alpha * p;
      r -= alpha * q;
      ++result.iterations;
    }
    result.x = without_padding(x);
    return result;
  }

  IterationResult over_relaxation(const Eigen::VectorXd& b, const Eigen::VectorXd& start, double omega,
                                  const IterationLimits& limits) const override {
    IterationResult result{start, 0, false};
    std::vector<Square> inverse;
    for (int i = 0; i < rows_.count(); ++i) inverse.push_back(rows_.blocks[at(diagonal(i))].inverse());
    Eigen::VectorXd x = with_padding(start);
    const Eigen::VectorXd right = with_padding(b);
    const double goal = limits.residual * right.norm();
    Eigen::VectorXd product(x.size());
    const auto residual = [&] {
      multiply(x, product);
      return (right - product).norm();
    };
    while (!(result.converged = residual() <= goal) && result.iterations < limits.count) {
      for (int i = 0; i < rows_.count(); ++i) {
        Eigen::Matrix<double, N, 1> r = right.template segment<N>(N * i);
        for (int e = rows_.begin[at(i)]; e < rows_.begin[at(i) + 1]; ++e)
          r.noalias() -= rows_.blocks[at(e)] * x.template segment<N>(N * rows_.columns[at(e)]);
        x.template segment<N>(N * i).noalias() += omega * (inverse[at(i)] * r);
      }
      ++result.iterations;
    }
    result.x = without_padding(x);
    return result;
  }

 private:
  template <class Block>
  static Square padded(const Block& block) {
    if (block.rows() == N && block.cols() == N) return block;
    Square all = Square::Zero();
    all.topLeftCorner(block.rows(), block.cols()) = block;
    return all;
  }

  int diagonal(int i) const {
    const auto begin = rows_.columns.begin();
    return static_cast<int>(std::lower_bound(begin + rows_.begin[at(i)], begin + rows_.begin[at(i) + 1], i) - begin);
  }

  // y = A x.
  void multiply(const Eigen::VectorXd& x, Eigen::VectorXd& y) const {
    for (int i = 0; i < rows_.count(); ++i) {
      Eigen::Matrix<double, N, 1> sum = Eigen::Matrix<double, N, 1>::Zero();
      for (int e = rows_.begin[at(i)]; e < rows_.begin[at(i) + 1]; ++e)
        sum.noalias() += rows_.blocks[at(e)] * x.template segment<N>(N * rows_.columns[at(e)]);
      y.template segment<N>(N * i) = sum;
    }
  }

  Eigen::VectorXd with_padding(const Eigen::VectorXd& x) const {
    Eigen::VectorXd all = Eigen::VectorXd::Zero(N * rows_.count());
    for (int i = 0; i < rows_.count(); ++i)
      all.segment(N * i, sizes_[at(i)]) = x.segment(first_rows_[at(i)], sizes_[at(i)]);
    return all;
  }
  Eigen::VectorXd without_padding(const Eigen::VectorXd& all) const {
    Eigen::VectorXd x(unknowns_);
    for (int i = 0; i < rows_.count(); ++i)
      x.segment(first_rows_[at(i)], sizes_[at(i)]) = all.segment(N * i, sizes_[at(i)]);
    return x;
  }

  Rows<N> rows_;
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
