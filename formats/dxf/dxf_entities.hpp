// The entities of a DXF file as chains of points.
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

/// What one entity draws, in the unit of the file. Views the document.
struct DxfShape {
  std::string_view type;
  std::string_view layer;
  Place place;
  bool is_point = false;
  bool is_closed = false;                     ///< a side runs from the last point to the first
  std::vector<Point> points;                  ///< curves as chords
  std::vector<std::string_view> side_layers;  ///< POLYLINE: layer of the VERTEX at which each side begins
  std::optional<std::array<double, 3>> bolt;  ///< extended data: stiffness, strength, pre-tension
  std::uint32_t curves = 0;                   ///< arcs, circles, ellipses, splines and bulges in it
  std::uint32_t chords = 0;                   ///< that they became
  double low = 0;                             ///< z of its lowest point; not a number where its plane is tilted
  double high = 0;                            ///< likewise of its highest
  int colour = 0;                             ///< group 62; 0 where it has none of its own
  char mark = 0;  ///< F, L, M or H: a text of that letter alone, at its point; 0 for all else
};

struct DxfShapes {
  std::vector<DxfShape> shapes;
  DxfSkipped skipped;
  std::set<std::string_view> unread_layers = {};  ///< on which something is skipped
  DxfHidden hidden = {};                          ///< left out because it is not seen in the drawing program
  Warnings warnings;
};

/// The shapes of the section ENTITIES that `layers` shows. Throws InputError where an entity lacks a value or has a
/// wrong one, where a block is drawn within itself, and where INSERT would draw more than `DxfDefinitions` allows.
DxfShapes read_entities(const DxfDocument& document, std::span<const DxfRecord> records, DxfDefinitions& definitions,
                        const DxfVisibility& layers);

/// Keeps the shapes of one level plane, the one with most of them, and lists the others as skipped.
void keep_one_plane(DxfShapes& shapes);

}  // namespace keyblock::formats
