// Commas part numbers here, and elsewhere they are decimal points: what could be either is not guessed.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/text/tokens.hpp"

namespace keyblock::formats {

/// Throws InputError at the first comma among the numbers of a native text that may be a decimal comma or part
/// thousands: `22,5`, `,5`, `1,200`, `1.234,5` without white space. A text whose commas elsewhere can only part numbers
/// (`0.5,3`, `1,2,3`) is believed, but not on a line where white space alone parts numbers as well.
void refuse_decimal_commas(const Tokens& tokens);

/// The same for `size` characters from `first` on of the text that `map` is of.
void refuse_decimal_commas(const TextMap& map, std::string_view text, std::size_t first, std::size_t size);

}  // namespace keyblock::formats
