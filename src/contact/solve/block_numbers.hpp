// Numbers the blocks on which contact forces act for a factorisation, once for all active sets of a problem.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "contact/rows/contact_row.hpp"
#include "system/block_factor.hpp"

namespace keyblock {

/// Unknowns that respond to forces, block by block, and the pairs of blocks with a contact.
class BlockNumbers {
 public:
  /// Numbers the blocks. `store`: factorisations left by other numberings; null: a new store.
  BlockNumbers(const ContactRows& rows, const Flexibility& flexibility, std::shared_ptr<FactorStore> store = {});

  /// Returns the number of an element; −1 if it cannot move.
  int of(ElementIndex e) const { return numbers_[e]; }
  /// Returns the number of unknowns of a block; 0 for −1.
  int size(int block) const { return block < 0 ? 0 : sizes_[static_cast<std::size_t>(block)]; }
  int first_row(int block) const { return first_rows_[static_cast<std::size_t>(block)]; }
  int row_count() const { return first_rows_.back(); }
  int count() const { return static_cast<int>(sizes_.size()); }
  /// Returns the inverse of the flexibility of a block.
  const UnknownBlock& stiffness(int block) const { return stiffness_[static_cast<std::size_t>(block)]; }

  /// Returns a factorisation with zero values, reusing one that was given back.
  std::unique_ptr<BlockFactor> take_factor(MatrixShape shape) const { return store_->take(sizes_, coupled_, shape); }
  void give_back(std::unique_ptr<BlockFactor> factor) const { store_->give_back(std::move(factor)); }

 private:
  Table<ElementIndex, int> numbers_;
  std::vector<int> sizes_;
  std::vector<int> first_rows_;
  std::vector<UnknownBlock> stiffness_;
  BlockPattern::Pairs coupled_;
  std::shared_ptr<FactorStore> store_;
};

}  // namespace keyblock
