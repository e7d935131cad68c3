// A drawing and an analysis as DDAML text; elements in ddaml_geometry.hpp and ddaml_analysis.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "formats/format.hpp"

namespace keyblock::formats {

/// One file of the parts the content has. What native files say and DDAML has other words for is turned into these: a
/// contact stiffness into a penalty factor, weights into the gravity of the first block material, properties of bolts
/// into `Boltproperties`. Throws std::invalid_argument where neither part is there, for bolts with properties but
/// without an analysis to write them to, and for a velocity carry-over between 0 and 1.
std::string ddaml_text(const Content& content);

}  // namespace keyblock::formats
