// Declares the schema of the settings that a case file or a stage sets.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

namespace keyblock::formats {

/// Returns one property per setting, with title, meaning, unit, limits and words of the table of settings.
nlohmann::ordered_json setting_properties();

}  // namespace keyblock::formats
