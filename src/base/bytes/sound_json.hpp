// Reads JSON that others wrote: a request, or a record in a folder that anybody may have changed.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

namespace keyblock {

/// Levels of arrays and objects that are read. Copying and writing a value needs stack for each of its levels.
inline constexpr int kMostJsonLevels = 200;

/// Returns the value; discarded (`is_discarded`) if the text is no JSON or has more levels.
nlohmann::ordered_json sound_json(std::string_view text, bool with_comments = false);

}  // namespace keyblock
