// The program as a man page.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace keyblock {

/// The whole program in roff, section 1: every command with its options and examples.
std::string man_page(const CLI::App& program);

}  // namespace keyblock
