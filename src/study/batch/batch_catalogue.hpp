// Converts rows of the catalogue to JSON and to a text table.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "report/catalogue_page.hpp"

namespace keyblock::study {

nlohmann::ordered_json json_of(const report::CatalogueRow& row);

/// Reads the row that `json_of` wrote. Throws nlohmann::json::exception for a missing item or one of a wrong type.
report::CatalogueRow row_of(const nlohmann::ordered_json& json);

/// Returns catalogue.json: every row, without pictures.
std::string catalogue_json(const std::vector<report::CatalogueRow>& rows);

/// Returns catalogue.csv with one row per job; several files, sums or answers in one cell are separated by " | ".
std::string catalogue_csv(const std::vector<report::CatalogueRow>& rows);

}  // namespace keyblock::study
