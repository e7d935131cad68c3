// Converts DXF shapes to a drawing, layer by layer.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/dxf/dxf_entities.hpp"
#include "formats/format.hpp"
#include "problem/drawing.hpp"

namespace keyblock::formats {

/// Drawing without its edge-node ratio, and the warnings about layers, curves and skipped entities. Coordinates are
/// multiplied by `scale`; InputError if one leaves the range of numbers.
struct DxfDrawing {
  Drawing drawing;
  Warnings warnings;
  MaterialNames names = {};  ///< of layers
};

/// Makes the drawing. `layers`: a table whose rows were checked.
DxfDrawing drawing_of(DxfShapes shapes, double scale, const LayerTable& layers = {});

}  // namespace keyblock::formats
