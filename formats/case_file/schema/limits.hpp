// Declares the limits of a number in a JSON schema.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include "problem/limits.hpp"

namespace keyblock::formats {

/// Adds `minimum` or `exclusiveMinimum`, and `maximum` or `exclusiveMaximum`, for ends that the range has.
void put_limits(nlohmann::ordered_json& schema, const Range& range);

}  // namespace keyblock::formats
