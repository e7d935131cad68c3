// Makes the report of all results below a folder: cards with small pictures, a table, a section for each.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "app/handout/handout.hpp"

namespace keyblock {

/// Returns the report of all runs and factors of safety in folders below `folder`. Runs of one case by both profiles,
/// in folders with the names of the profiles, share a card. Throws InputError if no result can be read.
Handout archive_document(const std::filesystem::path& folder, const std::string& project);

}  // namespace keyblock
