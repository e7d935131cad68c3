// Replaces names of materials or bolts in a case file by their numbers.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/format.hpp"
#include "formats/text/json_text.hpp"

namespace keyblock::formats {

/// Key of settings by name, in `run` and in stages.
inline constexpr std::string_view kSettings = "set";

/// Replaces names of materials and bolts by their numbers, counted from 1. Throws InputError for an unknown or
/// ambiguous name. Values with units are left to the reader (CaseReading::real). Returns the names of materials.
MaterialNames resolve_names(JsonText& text);

/// Returns true if a field may be a name that `resolve_names` replaces by a number.
bool takes_name(std::string_view field);

}  // namespace keyblock::formats
