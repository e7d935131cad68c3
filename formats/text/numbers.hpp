// Numbers to text and back, independent of locale: the shortest text that reads back the same.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace keyblock::formats {

/// Shortest decimal text that `parse_real` turns back into the same bits.
std::string format_real(double value);
void append_real(std::string& text, double value);
/// Appends twelve digits, as C prints %.12g. Tables have these.
void append_rounded(std::string& text, double value);
void append_integer(std::string& text, int value);

/// A finite real: decimal, optional sign `+`, Fortran `D` exponents, `.5`, `5.`. Nothing for anything else
/// (nan, inf, 1x).
std::optional<double> parse_real(std::string_view text);

}  // namespace keyblock::formats
