// Reads a table of the parts of DXF layers, for drawings whose layers have names of their own.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Text, one row per line, comma separated; the first line is
//   layer,part
// Each other row has the name of a layer (upper or lower case, in quotes if it has a comma) and a part. Parts are
// boundary (or outline), joint N, material N, bolt N, block N, fixed, load, measured, hole, ignored; N counts from 1,
// and is 1 if it is missing. The layer * stands for all layers without a row and without a known name. # begins a
// comment. A case file has the same words in its section `layers`.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "formats/dxf/dxf_layers.hpp"
#include "formats/format.hpp"

namespace keyblock::formats {

extern const Format kDxfLayers;

/// Throws InputError at the place of a row (`file` if it has none) with an unknown part, and at a layer's second row.
void check_layers(const LayerTable& table, const Place& file);

/// Parts of a table whose rows were checked.
class LayerParts {
 public:
  explicit LayerParts(const LayerTable& table);

  /// Returns the part of a layer that the table names; if two rows name it, of the first.
  std::optional<DxfLayer> named(std::string_view layer);
  /// Returns the part of all other layers, if the table has a row for them.
  std::optional<DxfLayer> other() const { return other_; }
  /// Returns the rows whose layer was never requested.
  std::vector<std::size_t> unused() const;

 private:
  const LayerTable& table_;
  std::vector<bool> used_;
  std::optional<DxfLayer> other_;
};

}  // namespace keyblock::formats
