// Files of the family that are recognised but not read, so that the refusal can name them.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Extended 1.5: first word begins `#!0xDDA`.
// Disk DDA (`.par`) [inferred]: 0, 1 or 2, then two reals between 0 and 1.
#pragma once

#include "formats/format.hpp"

namespace keyblock::formats {

extern const Format kDdaExtended;
extern const Format kDiskDda;

}  // namespace keyblock::formats
