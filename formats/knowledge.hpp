// Describes how well each layout is known, with a small sample, for users who have an old file.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "formats/format.hpp"

namespace keyblock::formats {

struct Knowledge {
  std::string_view format;    ///< its name
  std::string_view evidence;  ///< data, public source, or inferred
  std::string_view sample;    ///< empty if the layout is lost
};

/// Returns the entry of a format; every format has one.
const Knowledge& knowledge_of(const Format& format);

}  // namespace keyblock::formats
