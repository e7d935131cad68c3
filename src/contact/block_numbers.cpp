// Numbers in the order of the elements; a pattern from the pairs of touches.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/block_numbers.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cstddef>

namespace keyblock {
namespace {

// Leading unknowns that answer at all.
int answering(const UnknownBlock& flexibility) {
  int count = 0;
  while (count < flexibility.rows() && flexibility(count, count) > 0) ++count;
  return count;
}

UnknownBlock inverse_of(const UnknownBlock& flexibility, int size) {
  const UnknownBlock part = flexibility.topLeftCorner(size, size);
  return part.llt().solve(UnknownBlock::Identity(size, size));
}

}  // namespace

BlockNumbers::BlockNumbers(const ContactRows& rows, const Table<ElementIndex, UnknownBlock>& flexibility) {
  int row = 0;
  for (const UnknownBlock& of : flexibility) {
    const int size = answering(of);
    numbers_.push_back(size > 0 ? count() : -1);
    if (size == 0) continue;
    sizes_.push_back(size);
    stiffness_.push_back(inverse_of(of, size));
    first_rows_.push_back(row);
    row += size;
  }
  first_rows_.push_back(row);
  BlockPattern::Pairs coupled;
  for (std::size_t i = 0; i < rows.size(); i += 2) {
    const int a = numbers_[rows[i].vertex_element];
    const int b = numbers_[rows[i].edge_element];
    if (a >= 0 && b >= 0 && a != b) coupled.emplace_back(std::min(a, b), std::max(a, b));
  }
  std::ranges::sort(coupled);
  const auto repeated = std::ranges::unique(coupled);
  coupled.erase(repeated.begin(), repeated.end());
  pattern_ = std::make_shared<BlockPattern>(count(), coupled);
}

std::unique_ptr<BlockFactor> BlockNumbers::take_factor() const {
  if (!spare_) return std::make_unique<BlockFactor>(pattern_, sizes_);
  spare_->clear();
  return std::move(spare_);
}

}  // namespace keyblock
