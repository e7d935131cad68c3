// Adds options for the drawing among the inputs: `--layers FILE`, `--unit UNIT`, `--join DISTANCE`.
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

/// Returns the options in this order: layers, unit, join.
std::vector<CLI::Option*> add_drawing_options(CLI::App& options, DrawingOptions& chosen);

/// Appends the table of layers to the other files, if there is one. Throws InputError if it is not a table of layers.
void take_layers(std::vector<std::string>& files, const std::string& layers);

}  // namespace keyblock
