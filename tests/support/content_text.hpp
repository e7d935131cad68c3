// Everything a file's content holds but places, as text: two contents are equal where their texts are.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "formats/format.hpp"

namespace keyblock::support {

/// One line a record, reals to the last bit.
std::string content_text(const formats::Content& content);

}  // namespace keyblock::support
