// Declares limits of numbers in a JSON schema, found from the condition itself.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string_view>

namespace keyblock::formats {

/// Adds `minimum`, `exclusiveMinimum`, `maximum` and `exclusiveMaximum`. `wording` names the limits; `holds` decides at
/// and beside each of them.
void put_limits(nlohmann::ordered_json& schema, std::string_view wording, const std::function<bool(double)>& holds);

}  // namespace keyblock::formats
