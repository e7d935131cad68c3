// Writes the man page of the program.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace keyblock {

/// Returns the whole program in roff, section 1: every command with its options and examples.
std::string man_page(const CLI::App& program);

}  // namespace keyblock
