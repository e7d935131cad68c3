// Reads CIRCLE, ARC, ELLIPSE and SPLINE of a DXF file as chains of chords.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/dxf/dxf_shape.hpp"
#include "formats/dxf/entities/record_values.hpp"

namespace keyblock::formats {

/// Returns the shape in the plane of the entity, seen from the side of its normal.
DxfShape circle_of(const DxfRecordValues& values, const DxfRecord& record);
DxfShape arc_of(const DxfRecordValues& values, const DxfRecord& record);

/// Returns the shape in world coordinates, for any normal. A spline whose knots, points or weights make no curve has no
/// points.
DxfShape ellipse_of(const DxfDocument& document, const DxfRecordValues& values, const DxfRecord& record);
DxfShape spline_of(const DxfDocument& document, const DxfRecordValues& values, const DxfRecord& record);

}  // namespace keyblock::formats
