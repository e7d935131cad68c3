// Keyblock's own case file: one JSON text that holds whatever Keyblock models.
//
// An object; comments as in C++ are allowed, and a comma behind the last of a list. Numbers of blocks, materials, slots
// … count from 1; materials may be named instead. Angles in degrees, all else in one consistent set of units, which the
// file names; a value may carry a unit of its own ("20 GPa"), which is converted. Keys, in any order; what is absent
// keeps its default (a weight and an edge-node ratio not without a warning):
//   keyblock   the version of the layout: needed. 1; or 2, the same with other defaults: velocity_carry_over 1,
//              plane_strain true, allowed_displacement_ratio 0.01, and gravity 9.81 m/s2 where no unit weight is given
//   $schema    passed over; editors complete by it
//   units      length, mass, time: names of the base units
//   drawing | blocks | cover    the geometry: lines that are cut to blocks, blocks, or elements on covers; lists of
//                               rows. Of a drawing also the name of the file that holds it, from the folder of this one
//   covers     bodies on covers: mesh, functions, what holds and loads them; values may be expressions in x, y, nx, ny
//   analysis   controls, materials, loads in time
//   motion     rows time, x, y: acceleration over gravity
//   frames, tracks    results of a run: everything at instants, the ways of measured points; a run takes no notice of
//                     them
//   run        profile, and `set`: settings as `keyblock run --set` takes them
// `case_fields.hpp` names every key; `keyblock formats --schema` prints them with meaning, unit and default as
// JSON Schema.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "formats/format.hpp"

namespace keyblock::formats {

inline constexpr int kCaseVersion = 1;
/// The same keys, with the defaults of today: motion in time, plane strain, gravity, a displacement ratio.
inline constexpr int kCaseVersionOfToday = 2;

extern const Format kKeyblockCase;

/// Whether there is anything of it to write.
bool fits_a_case(const Content& content);

/// The layout as JSON Schema (draft 2020-12).
std::string case_schema();

}  // namespace keyblock::formats
