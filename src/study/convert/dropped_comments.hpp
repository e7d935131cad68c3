// Counts comments that the conversion of a file drops: no reader keeps them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "formats/case.hpp"

namespace keyblock::study {

/// Returns the number of comments as a warning at the first; empty without comments, or if the format has none.
std::optional<Warning> dropped_comments(const formats::FileReading& file);

}  // namespace keyblock::study
