// What the name of a DXF layer says: a role in the drawing and a number.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The name begins with a word of the table (upper or lower case) and may end in a number; what stands between is free:
// `JOINT_2`, `joints bedding 2`, `BOUNDARY`. Without one at the end a number right behind the word counts (`JOINT_2
// bedding`), without any 1.
//   BOUNDARY  boundary lines, n: joint material          FIXED     fixed lines and points
//   JOINT     joints, n: joint material                  LOAD      loading points, in the order of the file
//   MATERIAL  lines and points that give block material n  MEASURED  measured points
//   BOLT      bolts, n: bolt type                        HOLE      points whose blocks are taken out
//   BLOCK     outlines of blocks of block material n, closed polylines
// A table of layers (dxf_layer_table.hpp) overrules names. Any other layer holds joints; each such layer has a joint
// material of its own: the first number not yet taken.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace keyblock::formats {

enum class DxfRole { boundary, joint, material, bolt, block, fixed, load, measured, hole, ignored };

/// A role and a material from 0; `number_is_too_long`: it has more digits than a number of the program.
struct DxfLayer {
  DxfRole role = DxfRole::joint;
  int index = 0;
  bool number_is_too_long = false;
};

/// Nothing where the name begins with no word of the table.
std::optional<DxfLayer> layer_of(std::string_view name);

/// For a name that begins with no word of the table: `; did you mean "BOUNDARY"?`, or nothing. An outline, as the table
/// of layers calls it, is a boundary.
std::string hint_for_layer(std::string_view name);

/// Whether entities of the role are points and not lines.
bool holds_points_only(DxfRole role);

}  // namespace keyblock::formats
