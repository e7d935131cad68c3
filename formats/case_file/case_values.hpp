// What people may write where a case file holds numbers of materials or bolts: their names.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/format.hpp"
#include "formats/text/json_text.hpp"

namespace keyblock::formats {

/// The key of settings by name, in `run` and in stages.
inline constexpr std::string_view kSettings = "set";

/// Turns names of materials and bolts into the numbers that they stand for, counted from 1. Throws InputError for a
/// name that none has, or two. Values with units are the reader's (CaseReading::real). Returns the names of materials.
MaterialNames resolve_names(JsonText& text);

/// Whether a field may be a name for which `resolve_names` puts a number.
bool takes_name(std::string_view field);

}  // namespace keyblock::formats
