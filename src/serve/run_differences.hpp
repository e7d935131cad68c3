// Lists the differences of two runs by their records.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

namespace keyblock::serve {

inline constexpr std::size_t kMostDifferences = 500;

/// Returns the members with different values: path, first, second, for numbers the relative difference, and the units
/// of both if the records name any. Numbers with different units are compared in SI. Times of work, names of files and
/// the lists of columns are left out.
nlohmann::ordered_json run_differences(const nlohmann::ordered_json& first, const nlohmann::ordered_json& second);

/// Does the same for all entries of two values.
nlohmann::ordered_json value_differences(const nlohmann::ordered_json& first, const nlohmann::ordered_json& second);

}  // namespace keyblock::serve
