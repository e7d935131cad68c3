// A checksum by which bytes are known again.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace keyblock {

/// SHA-256 of the bytes, lower-case hexadecimal.
std::string sha256(std::string_view bytes);

}  // namespace keyblock
