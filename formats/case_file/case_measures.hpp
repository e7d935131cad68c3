// What the numbers of a case file measure, for values with units and for the schema.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "problem/units/measure.hpp"

namespace keyblock::formats {

/// Of the number under `key`, which stands under `parent` ("tractions", "x"): plain ones are `measures::kNumber`.
/// Nothing where the table does not know it, and so for all that is no number.
std::optional<Measure> measure_of(std::string_view parent, std::string_view key);

/// Whether a value with a unit may stand there.
bool takes_unit(std::string_view parent, std::string_view key);

/// Whether it is a strain, which may be written as a text in per cent or per mille: "1 %", "10 ‰".
bool takes_per_cent(std::string_view parent, std::string_view key);

}  // namespace keyblock::formats
