// An archive of many files as users leave them: samples of every dialect under names of every habit, some of them
// broken.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <set>
#include <string>

namespace keyblock::support {

struct MixedArchive {
  std::set<std::string> broken;    ///< paths below the root of files that no longer say what they should
  std::set<std::string> partners;  ///< of those: what a broken file should have been paired with
  std::size_t files = 0;
};

/// Writes `count` files below `root` in folders of 20 or so, of which about `broken_share` are cut off, emptied, made
/// binary or given a word for a number. The same seed gives the same bytes.
MixedArchive write_mixed_archive(const std::filesystem::path& root, std::size_t count, double broken_share,
                                 std::uint64_t seed);

}  // namespace keyblock::support
