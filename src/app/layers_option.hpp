// `--layers FILE`: a table of what the layers of a drawing are, beside the other inputs of a command.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace keyblock {

CLI::Option* add_layers_option(CLI::App& options, std::string& file);

/// The file behind the others, where there is one. Throws InputError where it is no table of layers.
void take_layers(std::vector<std::string>& files, const std::string& layers);

}  // namespace keyblock
