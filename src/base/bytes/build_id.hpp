// Identifies the build of the program.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace keyblock {

/// The hash that the linker made of the program or library that holds this code, lower-case hexadecimal
/// (NT_GNU_BUILD_ID of the ELF format). Two builds that could compute otherwise differ in it. Throws std::logic_error
/// if the linker left none.
std::string build_id();

}  // namespace keyblock
