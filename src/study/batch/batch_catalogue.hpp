// Rows of the catalogue as JSON and as a table of text.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "report/catalogue_page.hpp"

namespace keyblock::study {

nlohmann::ordered_json json_of(const report::CatalogueRow& row);

/// The row that `json_of` wrote. Throws nlohmann::json::exception where something is missing or of the wrong kind.
report::CatalogueRow row_of(const nlohmann::ordered_json& json);

/// catalogue.json: every row, without pictures.
std::string catalogue_json(const std::vector<report::CatalogueRow>& rows);

/// catalogue.csv: a row a job; several files, sums or answers in one cell are parted by " | ".
std::string catalogue_csv(const std::vector<report::CatalogueRow>& rows);

}  // namespace keyblock::study
