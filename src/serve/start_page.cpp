// Contains the start page; KEYBLOCK_START_PAGE is the path of the file, given by CMake.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "serve/start_page.hpp"

#include <cstddef>

__asm__(
    ".section .rodata\n"
    ".balign 16\n"
    "keyblock_start_page:\n"
    ".incbin \"" KEYBLOCK_START_PAGE
    "\"\n"
    "keyblock_start_page_end:\n"
    ".byte 0\n"
    ".previous\n");

extern "C" {
extern const char keyblock_start_page[] __attribute__((visibility("hidden")));
extern const char keyblock_start_page_end[] __attribute__((visibility("hidden")));
}

namespace keyblock::serve {

std::string_view start_page() {
  return {keyblock_start_page, static_cast<std::size_t>(keyblock_start_page_end - keyblock_start_page)};
}

}  // namespace keyblock::serve
