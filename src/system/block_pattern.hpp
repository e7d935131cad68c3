// Which blocks the factor of a sparse block matrix fills, eliminated in an order that keeps them few.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

namespace keyblock {

/// Symbolic factor of a block matrix with symmetric pattern: approximate minimum degree on the graph of blocks
/// (Amestoy, Davis & Duff 1996), then the union of what is eliminated with what it reaches (George & Liu 1981). It
/// depends on nothing but its arguments, so that a kept one gives the same numbers as a new one.
class BlockPattern {
 public:
  using Pairs = std::vector<std::pair<int, int>>;

  /// `coupled`: pairs of different blocks that share an entry, in any order and as often as they come.
  BlockPattern(int block_count, const Pairs& coupled);

  int block_count() const { return static_cast<int>(place_.size()); }
  /// When block i is eliminated.
  int place(int i) const { return place_[static_cast<std::size_t>(i)]; }
  /// Entries below the diagonal of the column eliminated at `column`: from `begin(column)` up to `begin(column + 1)`.
  int begin(int column) const { return begins_[static_cast<std::size_t>(column)]; }
  /// Place of the row of an entry, ascending within a column.
  int row(int entry) const { return rows_[static_cast<std::size_t>(entry)]; }
  int entry_count() const { return begins_.back(); }
  /// The entry of a coupled pair of places, row > column.
  int entry(int row, int column) const;

 private:
  std::vector<int> place_;
  std::vector<int> begins_;
  std::vector<int> rows_;
};

}  // namespace keyblock
