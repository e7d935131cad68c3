// Damages a text at random, for tests of readers.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <random>
#include <string>

namespace keyblock::support {

/// Changes the text one to four times: replaces, removes or inserts a byte, removes or doubles a stretch.
std::string mutated(std::string text, std::mt19937& random);

/// Repeats a stretch of up to 40 bytes in its place until the text is `size` bytes long or a little longer.
std::string stretched(const std::string& text, std::size_t size, std::mt19937& random);

}  // namespace keyblock::support
