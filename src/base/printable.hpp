// Makes names and words of files safe for a terminal, for tables and for XML.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace keyblock {

/// Returns the text with its control characters written out as `\x1b`, those of two bytes (U+0080 to U+009F) too. A
/// name in a file must not clear the reader's screen. Of more than 100 digits in a row it keeps the first 100 and "…".
std::string printable(std::string_view text);

/// Returns valid UTF-8: each byte that belongs to no character becomes a question mark in a lozenge (U+FFFD).
std::string valid_utf8(std::string_view text);

/// Returns the text for XML and HTML, as content or within double quotes: valid UTF-8, without the control characters
/// that XML 1.0 forbids.
std::string escape_xml(std::string_view text);

/// Returns the text as a cell of a table of comma-separated values (RFC 4180), in quotes if needed.
std::string csv_cell(std::string_view text);

}  // namespace keyblock
