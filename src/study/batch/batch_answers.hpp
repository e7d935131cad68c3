// Summarises a run of a batch from its record and history.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "report/catalogue_page.hpp"

namespace keyblock::study {

/// Returns the summary of a folder written by `keyblock run`: end, steps, and a displacement. It is that of the last
/// measured point or, without any, of the centroid of the last block. If the record is missing or damaged, `end` says
/// so.
report::CatalogueAnswer answer_in(const std::filesystem::path& folder, const std::string& profile);

/// Returns the verdict of `keyblock compare --json` in one sentence, one profile after the other.
std::string verdict_of(const std::string& comparison);

/// Returns the distance between the last answer and the first; empty unless both runs reached the end.
std::optional<double> difference_of(const std::vector<report::CatalogueAnswer>& answers);

}  // namespace keyblock::study
