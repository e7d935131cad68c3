// Stores the symmetric matrix of a step in small dense blocks, and its load vector.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <span>
#include <utility>
#include <vector>

namespace keyblock {

/// Largest number of rows of a block; raise it for a richer basis.
inline constexpr int kMostBlockRows = 6;

/// Symmetric matrix; only blocks (i, j) with i ≤ j are stored, contiguously. Block i has `size(i)` rows.
class BlockMatrix {
 public:
  using Block = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, kMostBlockRows, kMostBlockRows>;
  /// Pairs of different blocks, i < j, ascending, each once.
  using Pairs = std::vector<std::pair<int, int>>;
  struct Entry {
    int column;
    Block block;
  };

  /// Allocates blocks for `coupled` at once; they stay, zero or not. Others can be added, at the cost of moving the
  /// stored ones.
  explicit BlockMatrix(std::vector<int> sizes, const Pairs& coupled = {});

  /// Adds `block` (size(i) × size(j)) at (i, j), and with it its transpose at (j, i).
  void add(int i, int j, const Block& block);

  /// Returns the stored block (i, j), i ≤ j; zero if it is new.
  Block& block(int i, int j);

  int block_count() const { return static_cast<int>(sizes_.size()); }
  int size(int i) const { return sizes_[static_cast<std::size_t>(i)]; }
  /// Returns the first scalar row of block i; `first_row(block_count())` is the number of unknowns.
  int first_row(int i) const { return first_rows_[static_cast<std::size_t>(i)]; }
  int row_count() const { return first_rows_.back(); }
  /// Returns the diagonal block, then those to its right, columns ascending.
  std::span<const Entry> row(int i) const {
    return {entries_.data() + begins_[static_cast<std::size_t>(i)],
            entries_.data() + begins_[static_cast<std::size_t>(i) + 1]};
  }
  int entry_count() const { return static_cast<int>(entries_.size()); }

  /// Returns A x.
  Eigen::VectorXd operator*(const Eigen::VectorXd& x) const;

 private:
  std::vector<int> sizes_;
  std::vector<int> first_rows_;
  std::vector<std::size_t> begins_;
  std::vector<Entry> entries_;
};

/// Linear system A x = b of one solve.
struct System {
  BlockMatrix matrix;
  Eigen::VectorXd load;

  explicit System(std::vector<int> sizes, const BlockMatrix::Pairs& coupled = {});
  /// Returns the rows of block i in `load`.
  auto load_of(int i) { return load.segment(matrix.first_row(i), matrix.size(i)); }
};

}  // namespace keyblock
