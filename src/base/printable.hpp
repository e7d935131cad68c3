// Names and words of files as they may stand on a terminal and in tables.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace keyblock {

/// The text with its control characters written out, `\x1b`, those of two bytes (U+0080 to U+009F) too: a name in a
/// file must not clear the screen of who reads it. Of more than 100 digits in a row the first 100 and "…".
std::string printable(std::string_view text);

/// UTF-8, and a text that is none with a question mark in a lozenge (U+FFFD) for each byte that fits nowhere.
std::string valid_utf8(std::string_view text);

/// As a cell of a table of comma separated values (RFC 4180): in quotes where it has to be.
std::string csv_cell(std::string_view text);

}  // namespace keyblock
