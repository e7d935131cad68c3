// Returns title and physical quantity of entries of run.json, by their paths.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "problem/units/measure.hpp"

namespace keyblock {

/// Returns the quantity at a path such as "extremes.greatest_displacement.value" or "reactions[].driven": keys
/// separated by points, brackets for the items of a list. Returns nothing if the path is not known.
std::optional<Measure> measure_in_record(const std::string& path);

/// Returns the title of an entry, such as "Greatest displacement"; empty if it has none. Items of lists count from 1.
std::string title_in_record(std::string_view path);

/// Returns the unit of every number of the record that has one, by its path.
nlohmann::ordered_json units_of_numbers(const nlohmann::ordered_json& record, const Units& units);

}  // namespace keyblock
