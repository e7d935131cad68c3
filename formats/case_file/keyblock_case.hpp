// Keyblock's own case file: one JSON text that holds whatever Keyblock models.
//
// An object; comments as in C++ are allowed. Numbers of blocks, materials, slots … count from 1. Angles in degrees, all
// else in one consistent set of units, which the file names. Keys, in any order; what is absent keeps its default
// (a weight and an edge-node ratio not without a warning):
//   keyblock   1, the version of the layout: needed
//   units      length, mass, time: names of the base units
//   drawing | blocks | cover    the geometry: lines that are cut to blocks, blocks, or elements on covers; lists of
//                               rows
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

extern const Format kKeyblockCase;

/// Whether there is anything of it to write.
bool fits_a_case(const Content& content);

/// The layout as JSON Schema (draft 2020-12).
std::string case_schema();

}  // namespace keyblock::formats
