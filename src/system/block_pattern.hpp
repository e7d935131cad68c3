// Finds the blocks of the factorisation of a sparse block matrix, in an elimination order that keeps them few.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

namespace keyblock {

/// Symbolic factorisation of a block matrix with symmetric pattern. The order is that of approximate minimum degree on
/// the graph of blocks (Amestoy, Davis & Duff 1996). Each eliminated column is then united with those it reaches
/// (George & Liu 1981). It depends only on its arguments, so a stored pattern gives the same numbers as a new one.
class BlockPattern {
 public:
  using Pairs = std::vector<std::pair<int, int>>;

  /// `coupled`: pairs of different blocks that share an entry, in any order, repeated or not.
  BlockPattern(int block_count, const Pairs& coupled);

  int block_count() const { return static_cast<int>(place_.size()); }
  /// Returns the elimination step of block i.
  int place(int i) const { return place_[static_cast<std::size_t>(i)]; }
  /// Returns the first entry below the diagonal of the column eliminated at `column`; the last is before `begin(column
  /// + 1)`.
  int begin(int column) const { return begins_[static_cast<std::size_t>(column)]; }
  /// Returns the elimination step of the row of an entry, ascending within a column.
  int row(int entry) const { return rows_[static_cast<std::size_t>(entry)]; }
  int entry_count() const { return begins_.back(); }
  /// Returns the entry of a coupled pair of elimination steps, row > column.
  int entry(int row, int column) const;

 private:
  std::vector<int> place_;
  std::vector<int> begins_;
  std::vector<int> rows_;
};

}  // namespace keyblock
