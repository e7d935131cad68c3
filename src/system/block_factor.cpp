// Left-looking: a column is what was added to it less the products of all columns before it that reach it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/block_factor.hpp"

#include <Eigen/LU>
#include <algorithm>

namespace keyblock {

class BlockFactor::Kernel {
 public:
  virtual ~Kernel() = default;
  virtual void add(int i, int j, const Block& block) = 0;
  virtual bool factorise(bool is_symmetric) = 0;
  virtual void solve(std::span<double> b) const = 0;
};

namespace {

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

// Lists of columns, each filed under the row that it reaches next.
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

  KernelOf(std::shared_ptr<const BlockPattern> pattern, std::vector<int> sizes)
      : pattern_(std::move(pattern)),
        sizes_(std::move(sizes)),
        diagonal_(sizes_.size(), Square::Zero()),
        lower_(at(pattern_->entry_count()), Square::Zero()),
        upper_(lower_) {
    int row = 0;
    first_rows_.resize(sizes_.size());
    for (std::size_t i = 0; i < sizes_.size(); ++i) {
      first_rows_[i] = row;
      row += sizes_[i];
      diagonal_[at(pattern_->place(static_cast<int>(i)))].diagonal().tail(N - sizes_[i]).setOnes();
    }
  }

  void add(int i, int j, const BlockFactor::Block& block) override {
    const int a = pattern_->place(i);
    const int b = pattern_->place(j);
    if (a == b)
      diagonal_[at(a)].topLeftCorner(block.rows(), block.cols()) += block;
    else if (a > b)
      lower_[at(pattern_->entry(a, b))].topLeftCorner(block.rows(), block.cols()) += block;
    else
      upper_[at(pattern_->entry(b, a))].topLeftCorner(block.cols(), block.rows()) += block.transpose();
  }

  // Of column j, `lower_` becomes L (rows below) and `upper_` the transposed rows of D U to the right.
  bool factorise(bool is_symmetric) override {
    Reaching reaching(*pattern_);
    std::vector<int> places(diagonal_.size());  // entry of each row in the column at hand
    for (int j = 0; j < pattern_->block_count(); ++j) {
      const int begin = pattern_->begin(j);
      const int end = pattern_->begin(j + 1);
      for (int entry = begin; entry < end; ++entry) places[at(pattern_->row(entry))] = entry;
      for (int k = reaching.first(j); k >= 0;) {
        const int after = reaching.next(k);
        const int reached = reaching.entry(k);
        subtract(j, k, reached, places, is_symmetric);
        reaching.file(k, reached + 1);
        k = after;
      }
      Square& pivot = diagonal_[at(j)];
      const Eigen::PartialPivLU<Square> lu(pivot);
      pivot = lu.inverse();
      if (!pivot.allFinite()) return false;
      for (int entry = begin; entry < end; ++entry) {
        if (is_symmetric) upper_[at(entry)] = lower_[at(entry)];
        const Square raw = lower_[at(entry)];
        lower_[at(entry)].noalias() = raw * pivot;
      }
      reaching.file(j, begin);
    }
    return true;
  }

  void solve(std::span<double> b) const override {
    std::vector<Column> x(diagonal_.size(), Column::Zero());
    for (std::size_t i = 0; i < sizes_.size(); ++i)
      for (int r = 0; r < sizes_[i]; ++r) x[at(pattern_->place(static_cast<int>(i)))][r] = b[at(first_rows_[i] + r)];
    for (int j = 0; j < pattern_->block_count(); ++j)
      for (int entry = pattern_->begin(j); entry < pattern_->begin(j + 1); ++entry)
        x[at(pattern_->row(entry))].noalias() -= lower_[at(entry)] * x[at(j)];
    for (int j = pattern_->block_count() - 1; j >= 0; --j) {
      Column sum = x[at(j)];
      for (int entry = pattern_->begin(j); entry < pattern_->begin(j + 1); ++entry)
        sum.noalias() -= upper_[at(entry)].transpose() * x[at(pattern_->row(entry))];
      x[at(j)].noalias() = diagonal_[at(j)] * sum;
    }
    for (std::size_t i = 0; i < sizes_.size(); ++i)
      for (int r = 0; r < sizes_[i]; ++r) b[at(first_rows_[i] + r)] = x[at(pattern_->place(static_cast<int>(i)))][r];
  }

 private:
  // What column k, which reaches row j by `reached`, takes from column j.
  void subtract(int j, int k, int reached, const std::vector<int>& places, bool is_symmetric) {
    const Square left = lower_[at(reached)];
    const Square right = upper_[at(reached)].transpose();
    diagonal_[at(j)].noalias() -= left * right;
    for (int entry = reached + 1; entry < pattern_->begin(k + 1); ++entry) {
      const int place = places[at(pattern_->row(entry))];
      lower_[at(place)].noalias() -= lower_[at(entry)] * right;
      if (!is_symmetric) upper_[at(place)].noalias() -= upper_[at(entry)] * left.transpose();
    }
  }

  std::shared_ptr<const BlockPattern> pattern_;
  std::vector<int> sizes_;
  std::vector<int> first_rows_;
  std::vector<Square> diagonal_;  ///< by place; inverted once factorised
  std::vector<Square> lower_;     ///< by entry
  std::vector<Square> upper_;     ///< by entry, transposed
};

}  // namespace

BlockFactor::BlockFactor(std::shared_ptr<const BlockPattern> pattern, std::vector<int> sizes) {
  const int largest = sizes.empty() ? 0 : *std::ranges::max_element(sizes);
  if (largest <= 3)
    kernel_ = std::make_unique<KernelOf<3>>(std::move(pattern), std::move(sizes));
  else
    kernel_ = std::make_unique<KernelOf<kMostBlockRows>>(std::move(pattern), std::move(sizes));
}

BlockFactor::BlockFactor(BlockFactor&&) noexcept = default;
BlockFactor& BlockFactor::operator=(BlockFactor&&) noexcept = default;
BlockFactor::~BlockFactor() = default;

void BlockFactor::add(int i, int j, const Block& block) {
  kernel_->add(i, j, block);
}

bool BlockFactor::factorise(bool is_symmetric) {
  return kernel_->factorise(is_symmetric);
}

void BlockFactor::solve(std::span<double> b) const {
  kernel_->solve(b);
}

}  // namespace keyblock
