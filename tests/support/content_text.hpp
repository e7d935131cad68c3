// Writes the contents of a file as text, without their places. Two contents are equal if their texts are.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "formats/format.hpp"

namespace keyblock::support {

/// Returns one line per record, with reals to the last bit.
std::string content_text(const formats::Content& content);

}  // namespace keyblock::support
