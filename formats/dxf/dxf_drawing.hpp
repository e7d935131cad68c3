// DXF shapes to a drawing, layer by layer.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/dxf/dxf_entities.hpp"
#include "formats/format.hpp"
#include "problem/drawing.hpp"

namespace keyblock::formats {

/// The drawing, without its edge-node ratio, and what was said about layers, curves and skipped entities. Coordinates
/// are multiplied by `scale`; InputError where one leaves the range of numbers.
struct DxfDrawing {
  Drawing drawing;
  Warnings warnings;
  MaterialNames names = {};  ///< of layers
};

/// `layers`: a table whose rows were checked.
DxfDrawing drawing_of(DxfShapes shapes, double scale, const LayerTable& layers = {});

}  // namespace keyblock::formats
