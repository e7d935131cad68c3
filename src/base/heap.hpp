// Memory that was freed serves the next step: to have each page of it made anew costs as much as many loops over it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace keyblock {

/// From here on the heap keeps large pieces that are freed. For programs that make steps.
void keep_freed_memory();

}  // namespace keyblock
