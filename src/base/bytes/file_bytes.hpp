// The bytes of a file in memory, read by several threads into room that nothing was written to before.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace keyblock {

/// Of a regular file, as long as the system says it is. Throws InputError where it cannot be opened, or breaks off.
std::string file_bytes(const std::string& path);

/// The same, of a file longer than `most` its first bytes.
std::string file_head(const std::string& path, std::size_t most);

}  // namespace keyblock
