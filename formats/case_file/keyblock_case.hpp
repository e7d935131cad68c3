// Reads and writes Keyblock's own case file: one JSON text that holds all that Keyblock models.
//
// The file is an object. Comments as in C++ are allowed, and a comma after the last item of a list. Numbers of blocks,
// materials, slots … count from 1; materials may be named instead. Angles are in degrees, all else in one consistent
// set of units, which the file names. A value may have a unit of its own ("20 GPa"), which is converted. Keys are in
// any order. Missing keys keep their default (a weight and an edge-node ratio only with a warning):
//   keyblock   the version of the layout: required. 1; or 2, the same with other defaults: velocity_carry_over 1,
//              plane_strain true, allowed_displacement_ratio 0.01, and gravity 9.81 m/s2 if no unit weight is given
//   $schema    ignored; editors use it for completion
//   units      length, mass, time: names of the base units
//   drawing | blocks | cover    the geometry: lines that are cut to blocks, blocks, or elements on covers; lists of
//                               rows. A drawing may also be the name of its file, relative to the folder of this one
//   covers     NMM bodies: mesh, functions, supports and loads; values may be expressions in x, y, nx, ny
//   analysis   controls, materials, loads in time
//   motion     rows time, x, y: acceleration over gravity
//   frames, tracks    results of a run: everything at instants, the paths of measured points; a run ignores them
//   run        profile, and `set`: settings in the form of `keyblock run --set`
// `case_fields.hpp` names every key; `keyblock formats --schema` prints them with meaning, unit and default as JSON
// Schema.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "formats/format.hpp"

namespace keyblock::formats {

inline constexpr int kCaseVersion = 1;
/// Version with the same keys and other defaults: motion in time, plane strain, gravity, a displacement ratio.
inline constexpr int kCaseVersionOfToday = 2;

extern const Format kKeyblockCase;

/// Returns true if the content has anything that a case file can hold.
bool fits_a_case(const Content& content);

/// Returns the layout as JSON Schema (draft 2020-12).
std::string case_schema();

}  // namespace keyblock::formats
