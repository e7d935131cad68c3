// Factorises sparse matrices of dense blocks of one fixed size: left-looking, without pivoting between blocks.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "system/block_matrix.hpp"
#include "system/block_pattern.hpp"

namespace keyblock {

/// Shape of a matrix. A symmetric one must be positive definite; a pair of coupled blocks is added once, in either
/// order, and the factor needs half the work and memory. In a general one both halves are added.
enum class MatrixShape { symmetric, general };

/// Factorisation A = L U of a sparse block matrix with symmetric pattern. Its values need not be symmetric: those of
/// Coulomb slip are not. Small blocks make it several times faster than a scalar factorisation (on a wall of 1,000
/// blocks 5 times Eigen's, 4 times CHOLMOD's). Blocks may differ in size up to N = 3 or 6, the smallest that holds all;
/// smaller ones are padded.
class BlockFactor {
 public:
  using Block = BlockMatrix::Block;

  /// `sizes`: rows of each block, at most `kMostBlockRows`. All values are zero.
  BlockFactor(std::shared_ptr<const BlockPattern> pattern, std::vector<int> sizes, MatrixShape shape);
  BlockFactor(BlockFactor&&) noexcept;
  BlockFactor& operator=(BlockFactor&&) noexcept;
  ~BlockFactor();

  /// Sets all values to zero, for a matrix of this shape.
  void clear(MatrixShape shape);

  /// Adds to block (i, j), size(i) × size(j); i and j are equal or coupled in the pattern.
  void add(int i, int j, const Block& block);

  /// Replaces the values by their factorisation; returns false if a pivot block is exactly singular or a value is not
  /// finite.
  bool factorise();

  /// Replaces b by A⁻¹ b. The rows of block i are contiguous, block after block.
  void solve(std::span<double> b) const;

  bool has(const std::shared_ptr<const BlockPattern>& pattern) const { return pattern_ == pattern; }

  /// Interface of the kernels, one per block size.
  class Kernel;

 private:
  std::shared_ptr<const BlockPattern> pattern_;
  std::unique_ptr<Kernel> kernel_;
};

/// Keeps a factorisation for the next one: its pattern, if blocks and couplings are the same, and its memory. It lends
/// one at a time.
class FactorStore {
 public:
  /// Returns a factorisation whose values are zero.
  std::unique_ptr<BlockFactor> take(const std::vector<int>& sizes, const BlockPattern::Pairs& coupled,
                                    MatrixShape shape);
  void give_back(std::unique_ptr<BlockFactor> factor);

 private:
  std::vector<int> sizes_;
  BlockPattern::Pairs coupled_;
  std::shared_ptr<const BlockPattern> pattern_;
  std::unique_ptr<BlockFactor> spare_;
};

/// Inverse of one block; `exists` is false if it is singular. A symmetric block must be positive definite; the inverse
/// of another must have a positive diagonal.
struct BlockInverse {
  BlockFactor::Block inverse;
  bool exists = true;
};
BlockInverse inverse_of(const BlockFactor::Block& block, bool is_symmetric);

}  // namespace keyblock
