// Returns the physical quantity of each number of run.json, by its path.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "problem/units/measure.hpp"

namespace keyblock {

/// Returns the quantity at a path such as "extremes.greatest_displacement.value" or "reactions[].driven": keys
/// separated by points, brackets for the items of a list. Returns nothing if the path is not known.
std::optional<Measure> measure_in_record(const std::string& path);

/// Returns the unit of every number of the record that has one, by its path.
nlohmann::ordered_json units_of_numbers(const nlohmann::ordered_json& record, const Units& units);

}  // namespace keyblock
