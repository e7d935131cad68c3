// Reads the bytes of a file into memory that was not written to before, by several threads.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace keyblock {

/// Variable of the environment with folders, one per line. If it is set, no file outside of them is read: `serve` sets
/// it, since a case may name any file.
inline constexpr const char* kReadsBelow = "KEYBLOCK_READS_BELOW";

/// Returns the bytes of a regular file. Throws InputError if it cannot be opened, lies outside of `kReadsBelow`, or is
/// shorter than the system says.
std::string file_bytes(const std::string& path);

/// The same, of a file longer than `most` its first bytes.
std::string file_head(const std::string& path, std::size_t most);

}  // namespace keyblock
