// Declares the physical quantities of the numbers of a case file, for values with units and for the schema.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "problem/units/measure.hpp"

namespace keyblock::formats {

/// Returns the quantity of the number `key` under `parent` ("tractions", "x"): plain numbers are `measures::kNumber`.
/// Returns nothing if the table does not know it, in particular for values that are not numbers.
std::optional<Measure> measure_of(std::string_view parent, std::string_view key);

/// Returns true if a value with a unit is permitted there.
bool takes_unit(std::string_view parent, std::string_view key);

/// Returns true for a strain, which may be written as a text in per cent or per mille: "1 %", "10 ‰".
bool takes_per_cent(std::string_view parent, std::string_view key);

}  // namespace keyblock::formats
