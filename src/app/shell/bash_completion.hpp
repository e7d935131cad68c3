// The program as bash completes it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace keyblock {

/// A script for bash that completes commands, options, and values of options that take one of a few words.
std::string bash_completion(const CLI::App& program);

}  // namespace keyblock
