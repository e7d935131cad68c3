// Finds the folder of samples that may be used locally but not shipped. Tests that need them skip if it is absent.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdlib>
#include <filesystem>

namespace keyblock {

/// Returns the folder named by KEYBLOCK_SHARED, else `shared` beside the source folder. It need not exist.
inline std::filesystem::path shared_folder() {
  if (const char* named = std::getenv("KEYBLOCK_SHARED")) return named;
  return std::filesystem::path(KEYBLOCK_SOURCE_DIR) / ".." / "shared";
}

}  // namespace keyblock
