// Writes an archive of many files: samples of every dialect under names of every kind, some of them broken.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <set>
#include <string>

namespace keyblock::support {

struct MixedArchive {
  std::set<std::string> broken;    ///< paths below the root of files that are damaged
  std::set<std::string> partners;  ///< for these: the file that should have been the partner of a broken one
  std::size_t files = 0;
};

/// Writes `count` files below `root`, in folders of about 20. About `broken_share` of them are cut off, emptied, made
/// binary, or have a word instead of a number. The same seed gives the same bytes.
MixedArchive write_mixed_archive(const std::filesystem::path& root, std::size_t count, double broken_share,
                                 std::uint64_t seed);

}  // namespace keyblock::support
