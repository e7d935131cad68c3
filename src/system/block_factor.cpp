// Factorises left-looking: subtracts from each column the products of all earlier columns that reach it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/block_factor.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <type_traits>

#include "base/context.hpp"
#include "system/fours.hpp"

namespace keyblock {

class BlockFactor::Kernel {
 public:
  virtual ~Kernel() = default;
  virtual void clear(MatrixShape shape) = 0;
  virtual void add(int i, int j, const Block& block) = 0;
  virtual bool factorise() = 0;
  virtual void solve(std::span<double> b) const = 0;
};

namespace {

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

using Two [[gnu::vector_size(16), gnu::may_alias]] = double;

// Returns the entries 2 h and 2 h + 1.
Two& two(double* entries, int h) {
  return reinterpret_cast<Two*>(entries)[h];
}
const Two& two(const double* entries, int h) {
  return reinterpret_cast<const Two*>(entries)[h];
}

// Lists of columns, each under the row that it reaches next.
class Reaching {
 public:
  explicit Reaching(const BlockPattern& pattern)
      : pattern_(pattern), heads_(at(pattern.block_count()), -1), next_(heads_), entries_(heads_) {}

  void file(int column, int entry) {
    entries_[at(column)] = entry;
    if (entry == pattern_.begin(column + 1)) return;
    int& head = heads_[at(pattern_.row(entry))];
    next_[at(column)] = head;
    head = column;
  }
  int first(int row) const { return heads_[at(row)]; }
  int next(int column) const { return next_[at(column)]; }
  int entry(int column) const { return entries_[at(column)]; }

 private:
  const BlockPattern& pattern_;
  std::vector<int> heads_;
  std::vector<int> next_;
  std::vector<int> entries_;
};

template <int N>
class KernelOf : public BlockFactor::Kernel {
 public:
  using Square = Eigen::Matrix<double, N, N>;
  using Column = Eigen::Matrix<double, N, 1>;

  KernelOf(std::shared_ptr<const BlockPattern> pattern, std::vector<int> sizes, MatrixShape shape)
      : pattern_(std::move(pattern)),
        sizes_(std::move(sizes)),
        shape_(shape),
        diagonal_(sizes_.size()),
        pivots_(sizes_.size()),
        lower_(at(pattern_->entry_count())),
        upper_(is_symmetric() ? 0 : lower_.size()) {
    int row = 0;
    for (const int size : sizes_) {
      first_rows_.push_back(row);
      row += size;
    }
    fill_up();
  }

  void clear(MatrixShape shape) override {
    shape_ = shape;
    upper_.resize(is_symmetric() ? 0 : lower_.size());
    for (std::vector<Padded<N>>* blocks : {&diagonal_, &lower_, &upper_})
      for (Padded<N>& block : *blocks) set_zero(block);
    fill_up();
  }

  // Sets ones on the diagonal of the padding of smaller blocks.
  void fill_up() {
    for (std::size_t i = 0; i < sizes_.size(); ++i)
      diagonal_[at(pattern_->place(static_cast<int>(i)))].square().diagonal().tail(N - sizes_[i]).setOnes();
  }

  void add(int i, int j, const BlockFactor::Block& block) override {
    const int a = pattern_->place(i);
    const int b = pattern_->place(j);
    if (a == b)
      add(block, diagonal_[at(a)].square());
    else if (a > b)
      add(block, lower_[at(pattern_->entry(a, b))].square());
    else
      add(block.transpose(), (is_symmetric() ? lower_ : upper_)[at(pattern_->entry(b, a))].square());
  }

  // Factorises each pivot. Of column j, `lower_` becomes L (rows below) and `upper_` the transposed rows of U to the
  // right.
  bool factorise() override {
    Reaching reaching(*pattern_);
    std::vector<int> places(diagonal_.size());  // entry of each row in the present column
    for (int j = 0; j < pattern_->block_count(); ++j) {
      leave_if_stopped();
      const int begin = pattern_->begin(j);
      const int end = pattern_->begin(j + 1);
      for (int entry = begin; entry < end; ++entry) places[at(pattern_->row(entry))] = entry;
      for (int k = reaching.first(j); k >= 0;) {
        const int after = reaching.next(k);
        const int reached = reaching.entry(k);
        subtract(j, k, reached, places);
        reaching.file(k, reached + 1);
        k = after;
      }
      Pivot& pivot = pivots_[at(j)];
      const Padded<N>& block = diagonal_[at(j)];
      if (!(is_symmetric() ? pivot.factorise_symmetric(block) : pivot.factorise(block.square()))) return false;
      for (int entry = begin; entry < end; ++entry) {
        minus_product(lower_[at(entry)], lower_[at(entry)], pivot.minus_upper_inverse);
        if (!is_symmetric()) minus_product(upper_[at(entry)], upper_[at(entry)], pivot.minus_lower_inverse);
      }
      reaching.file(j, begin);
    }
    return true;
  }

  void solve(std::span<double> b) const override {
    std::vector<Column> x(diagonal_.size(), Column::Zero());
    for (std::size_t i = 0; i < sizes_.size(); ++i)
      for (int r = 0; r < sizes_[i]; ++r) x[at(pattern_->place(static_cast<int>(i)))][r] = b[at(first_rows_[i] + r)];
    for (int j = 0; j < pattern_->block_count(); ++j) {
      const Column own = pivots_[at(j)].left(is_symmetric()).square().transpose() * -x[at(j)];
      x[at(j)] = own;
      for (int entry = pattern_->begin(j); entry < pattern_->begin(j + 1); ++entry)
        subtract(x[at(pattern_->row(entry))], lower_[at(entry)], own);
    }
    for (int j = pattern_->block_count() - 1; j >= 0; --j) {
      Column sum = x[at(j)];
      for (int entry = pattern_->begin(j); entry < pattern_->begin(j + 1); ++entry)
        subtract_transposed(sum, right(entry), x[at(pattern_->row(entry))]);
      x[at(j)].noalias() = pivots_[at(j)].minus_upper_inverse.square() * -sum;
    }
    for (std::size_t i = 0; i < sizes_.size(); ++i)
      for (int r = 0; r < sizes_[i]; ++r) b[at(first_rows_[i] + r)] = x[at(pattern_->place(static_cast<int>(i)))][r];
  }

 private:
  // Inverses of the factors of a pivot block P = L U, with the sign needed for products; that of L has its rows
  // permuted and is transposed. The inverse of P itself would lose as many digits as separate its stiffest unknown from
  // its softest.
  struct Pivot {
    Padded<N> minus_lower_inverse;
    Padded<N> minus_upper_inverse;

    // Returns false if the block is singular.
    bool factorise(const Square& block) {
      const Eigen::PartialPivLU<Square> lu(block);
      const Square of_lower =
          lu.matrixLU().template triangularView<Eigen::UnitLower>().solve(Square(lu.permutationP()));
      const Square of_upper = lu.matrixLU().template triangularView<Eigen::Upper>().solve(Square::Identity());
      minus_lower_inverse.square() = -of_lower.transpose();
      minus_upper_inverse.square() = -of_upper;
      return of_lower.allFinite() && of_upper.allFinite();
    }

    // Does the same for a symmetric block; returns false if it is not positive definite.
    bool factorise_symmetric(const Padded<N>& block) {
      return minus_inverse_of_cholesky(block, minus_upper_inverse) && minus_upper_inverse.square().allFinite();
    }

    // Returns the inverse of L; of a symmetric block it is that of U.
    const Padded<N>& left(bool is_symmetric) const { return is_symmetric ? minus_upper_inverse : minus_lower_inverse; }
  };

  // Most blocks have this size, which the compiler knows.
  template <class Of, class To>
  static void add(const Of& block, To to) {
    if (block.rows() == N && block.cols() == N)
      to += block.template topLeftCorner<N, N>();
    else
      to.topLeftCorner(block.rows(), block.cols()) += block;
  }

  // Computes y −= a x. Eigen multiplies six rows with more instructions, in the same order.
  static void subtract(Column& y, const Padded<N>& a, const Column& x) {
    if constexpr (N != 6) {
      y.noalias() -= a.square() * x;
    } else {
      for (int h = 0; h < 3; ++h) {
        Two sum{};
        for (int k = 0; k < 6; ++k) sum += two(a.columns[at(k)].data(), h) * x[k];
        two(y.data(), h) -= sum;
      }
    }
  }
  // Computes y −= aᵀ x.
  static void subtract_transposed(Column& y, const Padded<N>& a, const Column& x) {
    if constexpr (N != 6) {
      y.noalias() -= a.square().transpose() * x;
    } else {
      for (int j = 0; j < 6; ++j) {
        Two sum{};
        for (const int h : {1, 2, 0}) sum += two(a.columns[at(j)].data(), h) * two(x.data(), h);
        y[j] -= sum[0] + sum[1];
      }
    }
  }

  // Subtracts from column j the part of column k, which reaches row j by entry `reached`.
  void subtract(int j, int k, int reached, const std::vector<int>& places) {
    const Padded<N>& of_lower = lower_[at(reached)];
    const Padded<N>& of_upper = right(reached);
    subtract_product<true>(diagonal_[at(j)], of_lower, of_upper);
    for (int entry = reached + 1; entry < pattern_->begin(k + 1); ++entry) {
      const int place = places[at(pattern_->row(entry))];
      subtract_product<true>(lower_[at(place)], lower_[at(entry)], of_upper);
      if (!is_symmetric()) subtract_product<true>(upper_[at(place)], upper_[at(entry)], of_lower);
    }
  }

  bool is_symmetric() const { return shape_ == MatrixShape::symmetric; }
  // Returns an entry of U, transposed.
  const Padded<N>& right(int entry) const { return (is_symmetric() ? lower_ : upper_)[at(entry)]; }

  std::shared_ptr<const BlockPattern> pattern_;
  std::vector<int> sizes_;
  MatrixShape shape_;
  std::vector<int> first_rows_;
  std::vector<Padded<N>> diagonal_;  ///< by place
  std::vector<Pivot> pivots_;        ///< by place, once factorised
  std::vector<Padded<N>> lower_;     ///< by entry
  std::vector<Padded<N>> upper_;     ///< by entry, transposed; empty for a symmetric matrix
};

}  // namespace

BlockFactor::BlockFactor(std::shared_ptr<const BlockPattern> pattern, std::vector<int> sizes, MatrixShape shape)
    : pattern_(std::move(pattern)) {
  const int largest = sizes.empty() ? 0 : *std::ranges::max_element(sizes);
  if (largest <= 3)
    kernel_ = std::make_unique<KernelOf<3>>(pattern_, std::move(sizes), shape);
  else
    kernel_ = std::make_unique<KernelOf<kMostBlockRows>>(pattern_, std::move(sizes), shape);
}

BlockFactor::BlockFactor(BlockFactor&&) noexcept = default;
BlockFactor& BlockFactor::operator=(BlockFactor&&) noexcept = default;
BlockFactor::~BlockFactor() = default;

void BlockFactor::clear(MatrixShape shape) {
  kernel_->clear(shape);
}

void BlockFactor::add(int i, int j, const Block& block) {
  kernel_->add(i, j, block);
}

bool BlockFactor::factorise() {
  return kernel_->factorise();
}

void BlockFactor::solve(std::span<double> b) const {
  kernel_->solve(b);
}

std::unique_ptr<BlockFactor> FactorStore::take(const std::vector<int>& sizes, const BlockPattern::Pairs& coupled,
                                               MatrixShape shape) {
  if (!pattern_ || sizes != sizes_ || coupled != coupled_) {
    sizes_ = sizes;
    coupled_ = coupled;
    pattern_ = std::make_shared<BlockPattern>(static_cast<int>(sizes.size()), coupled);
    spare_.reset();
  }
  if (!spare_) return std::make_unique<BlockFactor>(pattern_, sizes, shape);
  spare_->clear(shape);
  return std::move(spare_);
}

void FactorStore::give_back(std::unique_ptr<BlockFactor> factor) {
  if (factor->has(pattern_)) spare_ = std::move(factor);
}

// Most blocks have the greatest size, which the compiler knows.
BlockInverse inverse_of(const BlockFactor::Block& block, bool is_symmetric) {
  if (!is_symmetric) {
    BlockInverse made{block.partialPivLu().inverse()};
    made.exists = made.inverse.allFinite() && (made.inverse.diagonal().array() > 0).all();
    return made;
  }
  const auto by_cholesky = [](const auto& whole) {
    const auto factor = whole.llt();
    BlockInverse made{factor.solve(std::decay_t<decltype(whole)>::Identity(whole.rows(), whole.cols()))};
    made.exists = factor.info() == Eigen::Success;
    return made;
  };
  if (block.rows() != kMostBlockRows) return by_cholesky(block);
  return by_cholesky(Eigen::Matrix<double, kMostBlockRows, kMostBlockRows>(block));
}

}  // namespace keyblock
