// Turns a case file into JSON that any parser reads, with all content except comments.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "formats/format.hpp"

namespace keyblock::formats {

/// Returns the values of a case file (JSON with comments and trailing commas, or YAML) as strict JSON. Names, units and
/// keys are unchanged, in their order, with two spaces of indentation. Throws InputError if the text is not
/// well-formed.
std::string strict_json(const Source& source);

}  // namespace keyblock::formats
