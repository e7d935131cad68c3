// Finds columns by name.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/columns/frame_part.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

namespace keyblock::formats {

std::size_t width_of(RowShape shape) {
  switch (shape) {
    case RowShape::number:
      return 1;
    case RowShape::xy:
      return 2;
    case RowShape::tensor:
    case RowShape::ends:
      return 4;
  }
  return 1;
}

const FrameColumn* FramePart::find(std::string_view column) const {
  const auto found = std::ranges::find(columns, column, &FrameColumn::name);
  return found == columns.end() ? nullptr : &*found;
}

const FrameColumn& FramePart::at(std::string_view column) const {
  if (const FrameColumn* found = find(column)) return *found;
  std::vector<std::string_view> names;
  for (const FrameColumn& c : columns) names.push_back(c.name);
  throw std::invalid_argument(
      fmt::format("expected a column of {} ({}), found \"{}\"", name, fmt::join(names, ", "), column));
}

}  // namespace keyblock::formats
