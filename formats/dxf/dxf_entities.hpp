// Reads the entities of a DXF file as chains of points.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <span>
#include <string_view>
#include <vector>

#include "formats/dxf/dxf_definitions.hpp"
#include "formats/dxf/dxf_groups.hpp"
#include "formats/dxf/dxf_shape.hpp"
#include "formats/dxf/dxf_skipped.hpp"
#include "formats/dxf/dxf_visibility.hpp"

namespace keyblock::formats {

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
