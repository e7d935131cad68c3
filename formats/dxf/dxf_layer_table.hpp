// A table that says what the layers of a DXF drawing are, for drawings whose layers have names of their own.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Text, a row a line, comma separated; the first line is
//   layer,part
// and each other one the name of a layer (upper or lower case, in quotes where it has a comma) and a part: boundary (or
// outline), joint N, material N, bolt N, block N, fixed, load, measured, hole, ignored; N counts from 1, and is 1 where
// it is missing. The layer * stands for all that neither the table nor their own names say. # begins a comment. A case
// file has the same words in its section `layers`.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "formats/dxf/dxf_layers.hpp"
#include "formats/format.hpp"

namespace keyblock::formats {

extern const Format kDxfLayers;

/// Throws InputError at the place of a row (`file` where it has none) whose part is none, and at a layer's second row.
void check_layers(const LayerTable& table, const Place& file);

/// The parts of a table whose rows were checked.
class LayerParts {
 public:
  explicit LayerParts(const LayerTable& table);

  /// Of a layer that the table names; where two rows do, of the first.
  std::optional<DxfLayer> named(std::string_view layer);
  /// Of all others, where the table has a row for them.
  std::optional<DxfLayer> other() const { return other_; }
  /// Rows whose layer was never asked for.
  std::vector<std::size_t> unused() const;

 private:
  const LayerTable& table_;
  std::vector<bool> used_;
  std::optional<DxfLayer> other_;
};

}  // namespace keyblock::formats
