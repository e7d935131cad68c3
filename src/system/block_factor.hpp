// The one factorisation that is our own: dense blocks of one fixed size, columns from the left, no pivoting between
// blocks.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "system/block_matrix.hpp"
#include "system/block_pattern.hpp"

namespace keyblock {

/// Of a symmetric matrix, which must be positive definite, a pair of coupled blocks is added once, either way round,
/// and the factor has half the work and half the room; of a general one both halves are.
enum class MatrixShape { symmetric, general };

/// A = L U of a sparse block matrix with symmetric pattern whose values need not be symmetric: Coulomb slip is not.
/// Small blocks make it several times faster than a scalar factor (on a wall of 1,000 blocks 5 times Eigen's, 4 times
/// CHOLMOD's). Blocks may differ in size up to N = 3 or 6, the smallest that holds all; smaller ones are padded.
class BlockFactor {
 public:
  using Block = BlockMatrix::Block;

  /// `sizes`: rows of each block, at most `kMostBlockRows`. All values are zero.
  BlockFactor(std::shared_ptr<const BlockPattern> pattern, std::vector<int> sizes, MatrixShape shape);
  BlockFactor(BlockFactor&&) noexcept;
  BlockFactor& operator=(BlockFactor&&) noexcept;
  ~BlockFactor();

  /// All values are zero again, of a matrix of this shape.
  void clear(MatrixShape shape);

  /// Adds to block (i, j), size(i) × size(j); i and j are equal or coupled in the pattern.
  void add(int i, int j, const Block& block);

  /// Replaces the values by the factor; false if a pivot block is exactly singular or a value is not finite.
  bool factorise();

  /// b becomes A⁻¹ b. Block i has its rows one after another, block after block.
  void solve(std::span<double> b) const;

  bool has(const std::shared_ptr<const BlockPattern>& pattern) const { return pattern_ == pattern; }

  /// Interface of the kernels, one for each size of block.
  class Kernel;

 private:
  std::shared_ptr<const BlockPattern> pattern_;
  std::unique_ptr<Kernel> kernel_;
};

/// What a factor leaves to the next one: its pattern, where blocks and couplings are the same, and its room. One at a
/// time is lent.
class FactorStore {
 public:
  /// A factor whose values are zero.
  std::unique_ptr<BlockFactor> take(const std::vector<int>& sizes, const BlockPattern::Pairs& coupled,
                                    MatrixShape shape);
  void give_back(std::unique_ptr<BlockFactor> factor);

 private:
  std::vector<int> sizes_;
  BlockPattern::Pairs coupled_;
  std::shared_ptr<const BlockPattern> pattern_;
  std::unique_ptr<BlockFactor> spare_;
};

/// Of one block. There is none where it is singular; a block said to be symmetric must be positive definite, another
/// must answer each of its unknowns by a positive diagonal.
struct BlockInverse {
  BlockFactor::Block inverse;
  bool exists = true;
};
BlockInverse inverse_of(const BlockFactor::Block& block, bool is_symmetric);

}  // namespace keyblock
