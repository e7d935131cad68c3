// Writes a drawing and an analysis as DDAML text; the elements are in ddaml_geometry.hpp and ddaml_analysis.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "formats/format.hpp"

namespace keyblock::formats {

/// Returns one file with the parts that the content has. Data of native files are converted: a contact stiffness to a
/// penalty factor, weights to the gravity of the first block material, properties of bolts to `Boltproperties`. Throws
/// std::invalid_argument if neither part exists, for bolts with properties but without an analysis, and for a velocity
/// carry-over between 0 and 1.
std::string ddaml_text(const Content& content);

}  // namespace keyblock::formats
