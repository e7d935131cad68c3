// The table is an input like others, recognised by its first line.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/layers_option.hpp"

#include "base/error.hpp"
#include "formats/dxf/dxf_layer_table.hpp"
#include "formats/registry.hpp"

namespace keyblock {

CLI::Option* add_layers_option(CLI::App& options, std::string& file) {
  return options
      .add_option("--layers", file,
                  "table that says what the layers of a DXF drawing are: lines layer,part below that heading "
                  "(`keyblock formats dxf-layers` shows one)")
      ->type_name("FILE");
}

void take_layers(std::vector<std::string>& files, const std::string& layers) {
  if (layers.empty()) return;
  const formats::Source source = formats::load(layers);
  if (formats::kDxfLayers.recognise(source).fit == formats::Recognition::Fit::none)
    throw InputError({layers, 1, 1}, "expected a table of layers, whose first line is layer,part; found another");
  files.push_back(layers);
}

}  // namespace keyblock
