// The unit of a DXF file: from its header as a factor, and to its header as a number.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "formats/dxf/dxf_groups.hpp"

namespace keyblock::formats {

/// What coordinates are multiplied with to the unit `length`, and the warning that says so. 1 and no unit where the
/// file names none ($INSUNITS absent or 0) and where its number is unknown.
struct DxfUnit {
  double factor = 1;
  std::string length = {};  ///< of the coordinates so multiplied, as a case file names it
  Warnings warnings = {};
};

/// `wanted` as a case file names it; metres where it is empty or no unit of DXF. `overruling`, where it is not empty,
/// counts in place of the file's own.
DxfUnit unit_of(const DxfDocument& document, std::string_view wanted, std::string_view overruling = {});

/// Units that may overrule that of a file, as case files name them.
std::vector<std::string> dxf_unit_names();

/// $INSUNITS of a length unit as a case file names it; 0 for any other.
int dxf_unit_number(std::string_view length);

}  // namespace keyblock::formats
