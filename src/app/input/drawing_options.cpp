// Adds the options of a drawing. The table of layers is an input file, recognised by its first line.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/input/drawing_options.hpp"

#include "app/option_checks.hpp"
#include "base/error.hpp"
#include "formats/dxf/dxf_layer_table.hpp"
#include "formats/dxf/dxf_units.hpp"
#include "formats/registry.hpp"

namespace keyblock {

std::vector<CLI::Option*> add_drawing_options(CLI::App& options, DrawingOptions& chosen) {
  return {
      options
          .add_option("--layers", chosen.layers,
                      "table of the meaning of DXF layers, with the heading layer,part (example: keyblock formats "
                      "dxf-layers)")
          ->type_name("FILE"),
      options.add_option("--unit", chosen.choices.unit, "unit of length of a DXF drawing, overrides its $INSUNITS")
          ->check(one_word_of(formats::dxf_unit_names())),
      options
          .add_option("--join", chosen.choices.join,
                      "join ends of lines to lines nearer than DISTANCE, in the unit of the drawing: closes gaps of "
                      "the outline, extends joints that end just short, trims those that overshoot")
          ->type_name("DISTANCE")
          ->check(above_zero())};
}

void take_layers(std::vector<std::string>& files, const std::string& layers) {
  if (layers.empty()) return;
  const formats::Source source = formats::load(layers);
  if (formats::kDxfLayers.recognise(source).fit == formats::Recognition::Fit::none)
    throw InputError({layers, 1, 1}, "expected a table of layers, whose first line is layer,part; found another");
  files.push_back(layers);
}

}  // namespace keyblock
