// Describes the origin of results: program, command and checksums, for run.json and sweep.json.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace keyblock {

/// Returns commit, compiler, build, command, folder of the command, and seed: null if no random number was drawn.
nlohmann::ordered_json made_by_json(const nlohmann::ordered_json& seed = {});

/// Names of files with their SHA-256 checksums.
using Checksums = std::vector<std::pair<std::string, std::string>>;

/// Returns the SHA-256 checksum of a file. Throws OutputError if it cannot be read.
std::string checksum_of(const std::filesystem::path& file);

}  // namespace keyblock
