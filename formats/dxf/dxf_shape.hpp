// Holds the shape of one entity of a DXF file: a chain of points with its layer, place and height.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "geometry/point.hpp"

namespace keyblock::formats {

/// Shape of one entity, in the unit of the file. Refers to the document.
struct DxfShape {
  std::string_view type;
  std::string_view layer;
  Place place;
  bool is_point = false;
  bool is_closed = false;                     ///< a side runs from the last point to the first
  std::vector<Point> points;                  ///< curves as chords
  std::vector<std::string_view> side_layers;  ///< POLYLINE: layer of the VERTEX at which each side begins
  std::optional<std::array<double, 3>> bolt;  ///< extended data: stiffness, strength, pre-tension
  std::uint32_t curves = 0;                   ///< arcs, circles, ellipses, splines and bulges
  std::uint32_t chords = 0;                   ///< number of chords of the curves
  double low = 0;                             ///< z of its lowest point; not a number if its plane is tilted
  double high = 0;                            ///< z of its highest point
  int colour = 0;                             ///< group 62; 0 if it has no colour of its own
  char mark = 0;                              ///< F, L, M or H: a text of that letter alone, at its point; otherwise 0
};

}  // namespace keyblock::formats
