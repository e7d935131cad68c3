// Returns the hash of a source file that the build makes by cmake/build_id.cmake.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/bytes/build_id.hpp"

namespace keyblock {

extern const char* const kBuildHash;

std::string build_id() {
  return kBuildHash;
}

}  // namespace keyblock
