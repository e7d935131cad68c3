// What people may write where a case file holds numbers: values with units, and names of materials.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/text/json_text.hpp"

namespace keyblock::formats {

/// Turns "20 GPa", "30 deg" and names of materials into the numbers that they stand for: values in the units that the
/// case declares, materials counted from 1. Fields that take a unit are listed in case_values.cpp; in all others a text
/// stays one. Throws InputError where a value is of another kind of quantity than its field, where its unit is not
/// known, or where the case declares no units; and for a name that no material has, or two.
void resolve_values(JsonText& text);

/// Whether a field may be a text for which `resolve_values` puts a number.
bool takes_text(std::string_view field);

}  // namespace keyblock::formats
