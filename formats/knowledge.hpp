// How well each layout is known, and a small sample of it, for people who hold an old file in their hands.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "formats/format.hpp"

namespace keyblock::formats {

struct Knowledge {
  std::string_view format;    ///< its name
  std::string_view evidence;  ///< data, public source, or inferred
  std::string_view sample;    ///< empty where the layout is lost
};

/// Every format has one.
const Knowledge& knowledge_of(const Format& format);

}  // namespace keyblock::formats
