// Places the shapes of a block where an INSERT draws them: scaled, rotated, moved, in rows and columns.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/dxf/dxf_definitions.hpp"
#include "formats/dxf/entities/record_values.hpp"
#include "geometry/point.hpp"

namespace keyblock::formats {

struct DxfInsertion {
  /// Throws InputError if a value is wrong.
  DxfInsertion(const DxfRecordValues& values, const DxfRecord& record, const DxfDefinition& definition);

  Point placed(Point p, int column, int row) const {
    return at + turned(Point{x * (p.x - base.x), y * (p.y - base.y)} + Point{column * array.x, row * array.y});
  }
  Point turned(Point p) const { return {cosine * p.x - sine * p.y, sine * p.x + cosine * p.y}; }

  Point base;
  Point at;
  double x = 1, y = 1, z = 1;  ///< scales
  double cosine = 1, sine = 0;
  double height = 0;  ///< added to z
  Point array;        ///< distance of columns, of rows, before the rotation
  int columns = 1, rows = 1;
};

}  // namespace keyblock::formats
