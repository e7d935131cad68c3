// Converts numbers to text and back, independently of the locale: the shortest text that reads back the same.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace keyblock::formats {

/// Returns the shortest decimal text that `parse_real` converts back to the same bits.
std::string format_real(double value);
void append_real(std::string& text, double value);
/// Appends twelve digits, like %.12g in C. Tables use it.
void append_rounded(std::string& text, double value);
void append_integer(std::string& text, int value);

/// Reads a finite real: decimal, optional sign `+`, Fortran `D` exponents, `.5`, `5.`. Returns nothing for other text
/// (nan, inf, 1x).
std::optional<double> parse_real(std::string_view text);

}  // namespace keyblock::formats
