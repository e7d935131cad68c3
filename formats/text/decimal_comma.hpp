// Rejects ambiguous commas: commas separate numbers here, and elsewhere they are decimal points.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/text/tokens.hpp"

namespace keyblock::formats {

/// Throws InputError at the first comma of a native text that may be decimal or separate thousands: `22,5`, `,5`,
/// `1,200`, `1.234,5` without white space. Accepts a text whose commas elsewhere can only separate numbers (`0.5,3`,
/// `1,2,3`), except on a line where white space alone separates numbers as well.
void refuse_decimal_commas(const Tokens& tokens);

/// Does the same for `size` characters of `text` from `first` on; `map` belongs to that text.
void refuse_decimal_commas(const TextMap& map, std::string_view text, std::size_t first, std::size_t size);

}  // namespace keyblock::formats
