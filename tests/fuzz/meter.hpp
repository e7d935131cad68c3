// Counts the bytes that a program allocates, by its own operator new. Only programs that limit readers link it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace keyblock::support {

/// Returns the bytes allocated now, as the allocator rounds them; those of pugixml too, after a call of `count_xml`.
std::size_t bytes_held();

/// Returns the largest number of bytes since the last `forget_peak`.
std::size_t peak_bytes();
void forget_peak();

/// Makes pugixml, which calls malloc, allocate through the counted operator.
void count_xml();

/// Returns the processor seconds of this program so far, all threads.
double processor_seconds();

}  // namespace keyblock::support
