// What a run of a batch came to, from the record and the history it left.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "report/catalogue_page.hpp"

namespace keyblock::study {

/// The answer in a folder that `keyblock run` wrote: end, steps, and the displacement of the last measured point or,
/// without any, of the centroid of the last block. Where the record is missing or damaged, `end` says so.
report::CatalogueAnswer answer_in(const std::filesystem::path& folder, const std::string& profile);

/// The verdict of `keyblock compare --json` in one sentence, a profile after the other.
std::string verdict_of(const std::string& comparison);

/// The distance between the last answer and the first, where both reached the end.
std::optional<double> difference_of(const std::vector<report::CatalogueAnswer>& answers);

}  // namespace keyblock::study
