// Makes the page of a run from its result folder: one file that a browser opens without a network.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace keyblock {

/// Returns the page. A killed run has no record; its frames are shown without it. Throws InputError if the folder has
/// no frames, or holds files that no run wrote.
std::string run_page(const std::filesystem::path& folder);

}  // namespace keyblock
