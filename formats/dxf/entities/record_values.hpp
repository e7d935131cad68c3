// Reads values of a DXF record by their groups, with an error for each that is wrong.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <vector>

#include "formats/dxf/dxf_entities.hpp"
#include "formats/dxf/dxf_groups.hpp"
#include "geometry/point.hpp"

namespace keyblock::formats {

/// A corner of a polyline and the bulge of the side that begins there.
struct DxfCorner {
  Point position;
  double bulge = 0;
  std::string_view layer;
};

/// Views the document. Throws InputError where a value lacks or is wrong.
class DxfRecordValues {
 public:
  explicit DxfRecordValues(const DxfDocument& document) : document_(document) {}

  double real(const DxfRecord& record, int code, std::string_view name) const;
  double real_or(double absent, const DxfRecord& record, int code, std::string_view name) const;
  int integer_or(int absent, const DxfRecord& record, int code, std::string_view name) const;
  int flags(const DxfRecord& record) const { return integer_or(0, record, 70, "the flags"); }
  bool is_in_paper_space(const DxfRecord& record) const { return integer_or(0, record, 67, "the space") == 1; }
  bool is_invisible(const DxfRecord& record) const { return integer_or(0, record, 60, "the visibility") == 1; }
  /// Layer "0" where none is given.
  static std::string_view layer_of(const DxfRecord& record);
  Point point(const DxfRecord& record, int code, std::string_view x, std::string_view y) const;
  /// Greater than 0.
  double radius(const DxfRecord& record) const;
  /// The z component of the plane's normal: 1, -1 where the plane is seen from below, 0 where it is tilted.
  int side_seen(const DxfRecord& record) const;
  /// A shape with layer, place and colour; its height is that of these groups.
  DxfShape shape_of(const DxfRecord& record, std::vector<Point> points, std::initializer_list<int> heights) const;
  /// Adds the height of these groups to a shape.
  void add_heights(DxfShape& shape, const DxfRecord& record, std::initializer_list<int> heights) const;
  /// The letter of a text that is one of the marks of the old Windows program; 0 for every other entity.
  static char mark_of(const DxfRecord& record);
  /// Corners of a LWPOLYLINE: group 10 opens a corner; 20 and 42 belong to the corner before them.
  std::vector<DxfCorner> light_corners(const DxfRecord& record) const;
  /// The extended data of a bolt: stiffness, strength, pre-tension.
  std::optional<std::array<double, 3>> bolt_of(const DxfRecord& record) const;

 private:
  const DxfDocument& document_;
};

}  // namespace keyblock::formats
