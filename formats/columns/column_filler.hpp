// Makes columns from a list of rows.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "formats/columns/frame_part.hpp"
#include "geometry/point.hpp"

namespace keyblock::formats {

using Components = std::array<double, 4>;  ///< xx, yy, xy, zz
using Ends = std::array<Point, 2>;
enum class Digits { all, seven };  ///< required by a viewer

/// Adds columns to a part, one value of a function per row. Refers to both.
template <class Row>
class ColumnFiller {
 public:
  ColumnFiller(FramePart& part, const std::vector<Row>& rows) : part_(part), rows_(rows) {}

  /// `value` takes a row and its index.
  template <class Value>
  void integer(std::string_view name, const Value& value) const {
    std::vector<int> numbers(rows_.size());
    for (std::size_t i = 0; i < rows_.size(); ++i) numbers[i] = value(rows_[i], i);
    add(name, RowShape::number, std::move(numbers), Digits::all);
  }

  template <class Value>
  void real(std::string_view name, const Value& value, Digits digits = Digits::all) const {
    fill<1>(name, RowShape::number, digits, [&](const Row& row, double* to) { *to = value(row); });
  }

  /// `value` returns a Point.
  template <class Value>
  void xy(std::string_view name, const Value& value, Digits digits = Digits::all) const {
    fill<2>(name, RowShape::xy, digits, [&](const Row& row, double* to) {
      const Point p = value(row);
      to[0] = p.x;
      to[1] = p.y;
    });
  }

  /// `value` returns Components.
  template <class Value>
  void tensor(std::string_view name, const Value& value, Digits digits = Digits::all) const {
    fill<4>(name, RowShape::tensor, digits, [&](const Row& row, double* to) {
      const Components c = value(row);
      std::copy(c.begin(), c.end(), to);
    });
  }

  /// `value` returns Ends.
  template <class Value>
  void ends(std::string_view name, const Value& value) const {
    fill<4>(name, RowShape::ends, Digits::all, [&](const Row& row, double* to) {
      const Ends e = value(row);
      to[0] = e[0].x;
      to[1] = e[0].y;
      to[2] = e[1].x;
      to[3] = e[1].y;
    });
  }

 private:
  template <std::size_t width, class Put>
  void fill(std::string_view name, RowShape shape, Digits digits, const Put& put) const {
    std::vector<double> numbers(width * rows_.size());
    for (std::size_t i = 0; i < rows_.size(); ++i) put(rows_[i], numbers.data() + width * i);
    add(name, shape, std::move(numbers), digits);
  }

  template <class T>
  void add(std::string_view name, RowShape shape, std::vector<T> numbers, Digits digits) const {
    part_.columns.push_back(
        {name, shape, std::make_shared<const std::vector<T>>(std::move(numbers)), digits == Digits::seven});
  }

  FramePart& part_;
  const std::vector<Row>& rows_;
};

}  // namespace keyblock::formats
