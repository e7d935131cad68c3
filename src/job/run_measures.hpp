// What the numbers of run.json measure, by where they stand.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "problem/units/measure.hpp"

namespace keyblock {

/// Of "extremes.greatest_displacement.value" or "reactions[].driven": keys with points between them, brackets for the
/// items of a list. Nothing where it is not known.
std::optional<Measure> measure_in_record(const std::string& path);

/// The unit of every number of the record that has one, by its path.
nlohmann::ordered_json units_of_numbers(const nlohmann::ordered_json& record, const Units& units);

}  // namespace keyblock
