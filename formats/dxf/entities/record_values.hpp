// Reads values of a DXF record by their groups, with an error for each wrong value.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <vector>

#include "formats/dxf/dxf_groups.hpp"
#include "formats/dxf/dxf_shape.hpp"
#include "geometry/point.hpp"

namespace keyblock::formats {

/// Corner of a polyline and the bulge of the side that begins there.
struct DxfCorner {
  Point position;
  double bulge = 0;
  std::string_view layer;
};

/// Reads values of records. Refers to the document. Throws InputError for a missing or wrong value.
class DxfRecordValues {
 public:
  explicit DxfRecordValues(const DxfDocument& document) : document_(document) {}

  double real(const DxfRecord& record, int code, std::string_view name) const;
  double real_or(double absent, const DxfRecord& record, int code, std::string_view name) const;
  int integer_or(int absent, const DxfRecord& record, int code, std::string_view name) const;
  int flags(const DxfRecord& record) const { return integer_or(0, record, 70, "the flags"); }
  bool is_in_paper_space(const DxfRecord& record) const { return integer_or(0, record, 67, "the space") == 1; }
  bool is_invisible(const DxfRecord& record) const { return integer_or(0, record, 60, "the visibility") == 1; }
  /// Returns layer "0" if none is given.
  static std::string_view layer_of(const DxfRecord& record);
  Point point(const DxfRecord& record, int code, std::string_view x, std::string_view y) const;
  /// Returns a radius greater than 0.
  double radius(const DxfRecord& record) const;
  /// Returns the z component of the plane's normal: 1, -1 if the plane is seen from below, 0 if it is tilted.
  int side_seen(const DxfRecord& record) const;
  /// Returns a shape with layer, place and colour; its height is that of these groups.
  DxfShape shape_of(const DxfRecord& record, std::vector<Point> points, std::initializer_list<int> heights) const;
  /// Adds the height of these groups to a shape.
  void add_heights(DxfShape& shape, const DxfRecord& record, std::initializer_list<int> heights) const;
  /// Returns the letter of a text that is a mark of the old Windows program; 0 for all other entities.
  static char mark_of(const DxfRecord& record);
  /// Returns the corners of a LWPOLYLINE: group 10 begins a corner; 20 and 42 belong to the corner before them.
  std::vector<DxfCorner> light_corners(const DxfRecord& record) const;
  /// Returns the extended data of a bolt: stiffness, strength, pre-tension.
  std::optional<std::array<double, 3>> bolt_of(const DxfRecord& record) const;

 private:
  const DxfDocument& document_;
};

}  // namespace keyblock::formats
