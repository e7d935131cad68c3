// Counts the bytes a program holds, by its own operator new: only the programs that hold readers to a limit link it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace keyblock::support {

/// Bytes held now, as the allocator rounds them; pugixml's too, once `count_xml` was called.
std::size_t bytes_held();

/// The most held since the last `forget_peak`.
std::size_t peak_bytes();
void forget_peak();

/// Lets pugixml, which calls malloc, allocate through the counted operator.
void count_xml();

/// Processor seconds of this program so far, all threads.
double processor_seconds();

}  // namespace keyblock::support
