// Comments of a file that its conversion leaves behind: no reader keeps them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "formats/case.hpp"

namespace keyblock::study {

/// How many comments the file has, as a warning at the first; nothing where it has none, or its format knows none.
std::optional<Warning> dropped_comments(const formats::FileReading& file);

}  // namespace keyblock::study
