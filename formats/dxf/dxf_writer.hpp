// Writes drawings as DXF text.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "formats/format.hpp"

namespace keyblock::formats {

/// Start of the comment (group 999) that keeps the edge-node ratio of a drawing.
inline constexpr std::string_view kDxfRatioComment = "keyblock edge-node ratio ";

/// Returns ASCII DXF R12 in metres; layout in dxf.hpp. Throws std::invalid_argument if there is no drawing.
std::string write_dxf(const Content& content);

}  // namespace keyblock::formats
