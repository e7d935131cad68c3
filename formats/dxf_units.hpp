// The unit of a DXF file, as a factor to metres.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/dxf_groups.hpp"

namespace keyblock::formats {

/// What coordinates are multiplied with, and the warning that says so. 1 for metres, where the file names no unit
/// ($INSUNITS absent or 0), and where its number is unknown.
struct DxfUnit {
  double metres = 1;
  Warnings warnings;
};

DxfUnit unit_of(const DxfDocument& document);

}  // namespace keyblock::formats
