// Damage done to a text at random, for tests of readers.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <random>
#include <string>

namespace keyblock::support {

/// One to four times: a byte replaced, removed or put in, a stretch removed or doubled.
std::string mutated(std::string text, std::mt19937& random);

/// A stretch of up to 40 bytes repeated where it stands until the text is `size` bytes long or a little longer.
std::string stretched(const std::string& text, std::size_t size, std::mt19937& random);

}  // namespace keyblock::support
