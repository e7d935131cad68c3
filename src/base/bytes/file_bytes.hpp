// Reads the bytes of a file into memory that was not written to before, by several threads.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace keyblock {

/// Returns the bytes of a regular file. Throws InputError if it cannot be opened, or is shorter than the system says.
std::string file_bytes(const std::string& path);

/// The same, of a file longer than `most` its first bytes.
std::string file_head(const std::string& path, std::size_t most);

}  // namespace keyblock
