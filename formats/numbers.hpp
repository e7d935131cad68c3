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
void append_integer(std::string& text, int value);

/// A finite real: decimal, optional sign `+`, Fortran `D` exponents, `.5`, `5.`. Nothing for anything else
/// (nan, inf, 1x).
std::optional<double> parse_real(std::string_view text);

/// The number a text begins with where it is a short plain decimal (at most 19 digits, whose value and power of ten are
/// exact doubles), and where it ends; null for every other text. The same bits as `parse_real`, several times sooner.
struct ShortReal {
  double value = 0;
  const char* end = nullptr;
};
ShortReal parse_short_real(const char* at, const char* last);

}  // namespace keyblock::formats
