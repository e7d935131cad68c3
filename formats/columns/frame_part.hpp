// Holds a part of one instant of a run as columns: tables of numbers, one row per block, contact, bolt or point.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

namespace keyblock::formats {

/// Meaning of the numbers of a row.
enum class RowShape { number, xy, tensor, ends };

std::size_t width_of(RowShape shape);

/// Numbers of all rows of a part, row after row without gaps. Copies share the numbers.
struct FrameColumn {
  std::string_view name;
  RowShape shape = RowShape::number;
  std::variant<std::shared_ptr<const std::vector<double>>, std::shared_ptr<const std::vector<int>>> numbers;
  bool is_brief = false;  ///< seven digits are enough for a viewer

  std::span<const double> reals() const { return *std::get<0>(numbers); }
  std::span<const int> integers() const { return *std::get<1>(numbers); }
};

struct FramePart {
  std::string_view name;
  std::size_t rows = 0;
  std::vector<FrameColumn> columns;

  /// Returns nullptr if the part has no such column.
  const FrameColumn* find(std::string_view column) const;
  /// Throws std::invalid_argument if the part has no such column.
  const FrameColumn& at(std::string_view column) const;
};

}  // namespace keyblock::formats
