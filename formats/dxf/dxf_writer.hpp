// Drawings to DXF text.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "formats/format.hpp"

namespace keyblock::formats {

/// What a comment (group 999) begins with that keeps the edge-node ratio of a drawing.
inline constexpr std::string_view kDxfRatioComment = "keyblock edge-node ratio ";

/// ASCII DXF R12 in metres; layout in dxf.hpp. Throws std::invalid_argument where there is no drawing.
std::string write_dxf(const Content& content);

}  // namespace keyblock::formats
