// What a command says of the drawing among its inputs: `--layers FILE`, `--unit UNIT`, `--join DISTANCE`.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "formats/format.hpp"

namespace keyblock {

struct DrawingOptions {
  std::string layers = {};  ///< file
  formats::DrawingChoices choices = {};

  bool operator==(const DrawingOptions&) const = default;
};

/// The options, in this order: layers, unit, join.
std::vector<CLI::Option*> add_drawing_options(CLI::App& options, DrawingOptions& chosen);

/// The table of layers behind the other files, where there is one. Throws InputError where it is no table of layers.
void take_layers(std::vector<std::string>& files, const std::string& layers);

}  // namespace keyblock
