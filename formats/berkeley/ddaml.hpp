// Reads and writes DDAML, the XML geometry and analysis files of Berkeley's DDA program.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Root `DDA` with `Geometry` and `Analysis`, one or both, any prefix and namespace; a root `Geometry` or
// `Analysis` is read too. Elements and attributes: ddaml_geometry.hpp, ddaml_analysis.hpp. Comments,
// processing instructions and the document type are skipped; the DTDs the files name are not public and never
// loaded.
#pragma once

#include "formats/format.hpp"

namespace keyblock::formats {

extern const Format kDdaml;

}  // namespace keyblock::formats
