// Writes the completion of the program for bash.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace keyblock {

/// Returns a script for bash that completes commands, options, and values of options with a list of words.
std::string bash_completion(const CLI::App& program);

}  // namespace keyblock
