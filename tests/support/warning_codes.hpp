// Finds the codes of warnings in the sources, by the calls and braces that make warnings.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

namespace keyblock::support {

/// Returns each code that the sources (src, formats) can give a `Warning`, with a file that does. A code is the first
/// part of a braced list of name, place and sentence, or an argument of a function that makes warnings. Both need an
/// underscore in the code. Codes of one word, or put together of parts, are not found, except those of DDAML defaults.
std::map<std::string, std::string> warning_codes();

/// Returns the text of all sources except the table of diagnostics.
std::string source_text();

}  // namespace keyblock::support
