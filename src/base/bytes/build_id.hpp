// Identifies the build of the program and the library.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace keyblock {

/// Returns the hash of all sources and of the flags of the compiler, lower-case hexadecimal. The program and the
/// library of one build have the same; two builds that could compute otherwise differ. cmake/build_id.cmake makes it.
std::string build_id();

}  // namespace keyblock
