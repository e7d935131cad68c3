// Counts bodies, which are numbered without gaps.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "result/field_frame.hpp"

#include <algorithm>

namespace keyblock {

std::size_t body_count(const FieldFrame& field) {
  int count = 0;
  for (const FieldElement& element : field.elements) count = std::max(count, element.body + 1);
  return static_cast<std::size_t>(count);
}

}  // namespace keyblock
