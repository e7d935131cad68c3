// Copies numbers from columns, and narrows them to seven digits if that suffices.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/views/vtk_arrays.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace keyblock::formats {
namespace {

/// Column, or one component of it.
struct ColumnSource {
  const FrameColumn* column;
  std::optional<std::size_t> component;  ///< of a tensor
};

std::optional<ColumnSource> source_of(const FramePart& part, std::string_view name) {
  if (const FrameColumn* column = part.find(name)) return ColumnSource{column, std::nullopt};
  constexpr std::array<std::string_view, 4> endings{"_xx", "_yy", "_xy", "_zz"};
  for (std::size_t i = 0; i < endings.size(); ++i) {
    if (!name.ends_with(endings[i])) continue;
    const FrameColumn* column = part.find(name.substr(0, name.size() - endings[i].size()));
    if (column && column->shape == RowShape::tensor) return ColumnSource{column, i};
  }
  return std::nullopt;
}

/// Calls `use` with the first of the `width` numbers of each written row.
template <class T, class Use>
void for_rows(std::span<const T> numbers, std::size_t width, std::span<const std::size_t> order, const Use& use) {
  if (order.empty())
    for (std::size_t at = 0; at < numbers.size(); at += width) use(numbers.data() + at);
  else
    for (const std::size_t row : order) use(numbers.data() + width * row);
}

template <class T>
void add_reals(VtkFile& file, std::string_view heading, const ColumnSource& from, std::span<const std::size_t> order) {
  const RowShape shape = from.column->shape;
  const bool are_vectors = shape == RowShape::xy || shape == RowShape::ends;
  const std::size_t width = width_of(shape);
  const std::size_t vectors = width / 2;
  std::vector<T> numbers;
  numbers.reserve((are_vectors ? 3 * vectors : 1) *
                  (order.empty() ? from.column->reals().size() / width : order.size()));
  for_rows(from.column->reals(), width, order, [&](const double* row) {
    if (!are_vectors) return numbers.push_back(static_cast<T>(row[from.component.value_or(0)]));
    for (std::size_t v = 0; v < vectors; ++v) {
      numbers.push_back(static_cast<T>(row[2 * v]));
      numbers.push_back(static_cast<T>(row[2 * v + 1]));
      numbers.push_back(T{0});
    }
  });
  file.add(heading, std::span<const T>(numbers), are_vectors ? 3 : 1);
}

void add_integers(VtkFile& file, std::string_view heading, const FrameColumn& column,
                  std::span<const std::size_t> order) {
  std::vector<std::int32_t> numbers;
  for_rows(column.integers(), 1, order, [&](const int* row) { numbers.push_back(*row); });
  file.add(heading, numbers);
}

}  // namespace

void add_arrays(VtkFile& file, const FramePart& part, const RunTable& table, const Units& units, ArraysOf of,
                std::span<const std::size_t> order) {
  for (const Column& declared : table.columns) {
    const std::optional<ColumnSource> from = source_of(part, declared.name);
    if (!from || (from->column->shape == RowShape::ends) != (of == ArraysOf::ends)) continue;
    const std::string name = heading(table, declared.name, units);
    if (from->column->numbers.index() == 1)
      add_integers(file, name, *from->column, order);
    else if (from->column->is_brief)
      add_reals<float>(file, name, *from, order);
    else
      add_reals<double>(file, name, *from, order);
  }
}

}  // namespace keyblock::formats
