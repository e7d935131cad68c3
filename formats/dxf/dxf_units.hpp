// Converts the unit of a DXF file: from its header to a factor, and to its header as a number.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "formats/dxf/dxf_groups.hpp"

namespace keyblock::formats {

/// Factor that converts coordinates to the unit `length`, and the warning about it. 1 and no unit if the file names
/// none ($INSUNITS absent or 0) or has an unknown number.
struct DxfUnit {
  double factor = 1;
  std::string length = {};  ///< of the converted coordinates, as a case file names it
  Warnings warnings = {};
};

/// Returns the conversion to `wanted`, as a case file names it; to metres if it is empty or not a unit of DXF. If
/// `overruling` is not empty, it replaces the unit of the file.
DxfUnit unit_of(const DxfDocument& document, std::string_view wanted, std::string_view overruling = {});

/// Returns the units that may override that of a file, as case files name them.
std::vector<std::string> dxf_unit_names();

/// Returns $INSUNITS of a length unit as a case file names it; 0 for any other.
int dxf_unit_number(std::string_view length);

}  // namespace keyblock::formats
