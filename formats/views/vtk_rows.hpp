// Arrays of a VTK file that have one number, or one vector, for each row of a list.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "formats/tables/run_tables.hpp"
#include "formats/views/vtk_file.hpp"
#include "geometry/point.hpp"
#include "problem/run_choices.hpp"

namespace keyblock::formats {

/// `table` declares the names; headings name `units`. Refers to file, rows, table and units.
template <class Rows>
class VtkRows {
 public:
  VtkRows(VtkFile& file, const Rows& rows, const RunTable& table, const Units& units)
      : file_(file), rows_(rows), table_(table), units_(units) {}

  /// T: double, float (seven digits) or std::int32_t. `value` takes a row and its place in the list.
  template <class T, class Value>
  void add(std::string_view name, const Value& value) {
    std::vector<T> numbers;
    numbers.reserve(rows_.size());
    for (std::size_t i = 0; i < rows_.size(); ++i) numbers.push_back(static_cast<T>(value(rows_[i], i)));
    file_.add(heading(table_, name, units_), numbers);
  }

  /// Vectors (x, y, 0). `value` makes of a row a list of points, one for each vector.
  template <class T, class Value>
  void add_vectors(std::string_view name, const Value& value) {
    std::vector<T> numbers;
    numbers.reserve(3 * rows_.size());
    for (const auto& row : rows_)
      for (const Point v : value(row)) numbers.insert(numbers.end(), {static_cast<T>(v.x), static_cast<T>(v.y), T{0}});
    file_.add(heading(table_, name, units_), numbers, 3);
  }

 private:
  VtkFile& file_;
  const Rows& rows_;
  const RunTable& table_;
  const Units& units_;
};

}  // namespace keyblock::formats
