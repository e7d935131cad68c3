// Reads the entities of a DXF file as chains of points.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <string_view>
#include <vector>

#include "formats/dxf/dxf_definitions.hpp"
#include "formats/dxf/dxf_groups.hpp"
#include "formats/dxf/dxf_skipped.hpp"
#include "formats/dxf/dxf_visibility.hpp"
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

struct DxfShapes {
  std::vector<DxfShape> shapes;
  DxfSkipped skipped;
  std::set<std::string_view> unread_layers = {};  ///< layers with skipped entities
  DxfHidden hidden = {};                          ///< left out because the drawing program does not show it
  Warnings warnings;
};

/// Returns the shapes of the section ENTITIES that `layers` shows. Throws InputError for a missing or wrong value, a
/// block drawn within itself, or more points from INSERT than `DxfDefinitions` allows.
DxfShapes read_entities(const DxfDocument& document, std::span<const DxfRecord> records, DxfDefinitions& definitions,
                        const DxfVisibility& layers);

/// Keeps the shapes of the level plane with most of them, and lists the others as skipped.
void keep_one_plane(DxfShapes& shapes);

}  // namespace keyblock::formats
