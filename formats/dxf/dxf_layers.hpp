// Reads the name of a DXF layer: a role in the drawing and a number.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The name begins with a word of the table (upper or lower case) and may end in a number; the text between is free:
// `JOINT_2`, `joints bedding 2`, `BOUNDARY`. Without a number at the end, one right after the word counts (`JOINT_2
// bedding`); otherwise it is 1.
//   BOUNDARY  boundary lines, n: joint material          FIXED     fixed lines and points
//   JOINT     joints, n: joint material                  LOAD      loading points, in the order of the file
//   MATERIAL  lines and points that give block material n  MEASURED  measured points
//   BOLT      bolts, n: bolt type                        HOLE      points whose blocks are removed
//   BLOCK     outlines of blocks of block material n, closed polylines
// A table of layers (dxf_layer_table.hpp) overrides names. Any other layer has joints. Each such layer has a joint
// material of its own: the first unused number.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace keyblock::formats {

enum class DxfRole { boundary, joint, material, bolt, block, fixed, load, measured, hole, ignored };

/// Role and material from 0; `number_is_too_long`: it has more digits than a number of the program.
struct DxfLayer {
  DxfRole role = DxfRole::joint;
  int index = 0;
  bool number_is_too_long = false;
};

/// Returns nothing if the name begins with no word of the table.
std::optional<DxfLayer> layer_of(std::string_view name);

/// Returns a hint for a name that begins with no word of the table: `; did you mean "BOUNDARY"?`, or nothing.
/// "Outline", the word of the table of layers, is a boundary.
std::string hint_for_layer(std::string_view name);

/// Returns true if entities of the role are points, not lines.
bool holds_points_only(DxfRole role);

}  // namespace keyblock::formats
