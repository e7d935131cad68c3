// Reads the tables of a result folder for the page of the run: curves, and points and crack tips in time.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "report/page/page_frame.hpp"

namespace keyblock {

inline constexpr std::size_t kMostTableRows = 1000;

/// Returns the curves over time of each table: name, title and columns. Longer tables keep every n-th row, the first
/// and the last. Units are left out if the case declares none. Throws InputError for a table that no run wrote.
nlohmann::ordered_json result_tables(const std::filesystem::path& folder, bool has_units);

/// Rows of each step.
using RowsByStep = std::map<int, report::PageRows>;

/// Returns the measured points, or the crack tips, of each step; empty without such a table.
RowsByStep points_by_step(const std::filesystem::path& folder, bool has_units);
RowsByStep tips_by_step(const std::filesystem::path& folder, bool has_units);

/// Returns the load factor of each step: that of crack growth, or the fraction of the loads on a path with limit loads.
/// Empty if the tables have neither.
std::map<int, double> load_factors(const std::filesystem::path& folder);

}  // namespace keyblock
