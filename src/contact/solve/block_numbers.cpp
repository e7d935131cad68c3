// Numbers the blocks in the order of the elements and takes the pattern from the pairs of contacts.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/solve/block_numbers.hpp"

#include <algorithm>
#include <cstddef>

#include "base/loop.hpp"

namespace keyblock {
namespace {

// Returns the number of leading unknowns that respond to forces.
int answering(const UnknownBlock& flexibility) {
  int count = 0;
  while (count < flexibility.rows() && flexibility(count, count) > 0) ++count;
  return count;
}

}  // namespace

BlockNumbers::BlockNumbers(const ContactRows& rows, const Flexibility& flexibility, std::shared_ptr<FactorStore> store)
    : store_(store ? std::move(store) : std::make_shared<FactorStore>()) {
  int row = 0;
  for (const UnknownBlock& block : flexibility.blocks) {
    const int size = answering(block);
    numbers_.push_back(size > 0 ? count() : -1);
    if (size == 0) continue;
    sizes_.push_back(size);
    first_rows_.push_back(row);
    row += size;
  }
  first_rows_.push_back(row);
  stiffness_.resize(sizes_.size());
  for_each_entry(numbers_.size(), [&](std::size_t i) {
    const ElementIndex e{static_cast<int>(i)};
    if (of(e) < 0) return;
    UnknownBlock& stiffness = stiffness_[static_cast<std::size_t>(of(e))];
    const int unknowns = size(of(e));
    if (!flexibility.inverses.empty() && unknowns == flexibility.inverses[e].rows())
      stiffness = flexibility.inverses[e];
    else
      stiffness =
          inverse_of(flexibility.blocks[e].topLeftCorner(unknowns, unknowns), flexibility.has_symmetric_blocks).inverse;
  });
  for (std::size_t i = 0; i < rows.size(); i += 2) {
    const int a = numbers_[rows[i].vertex_element];
    const int b = numbers_[rows[i].edge_element];
    if (a >= 0 && b >= 0 && a != b) coupled_.emplace_back(std::min(a, b), std::max(a, b));
  }
}

}  // namespace keyblock
