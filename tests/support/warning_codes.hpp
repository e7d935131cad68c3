// Finds the codes of warnings in the sources, by the calls and braces that make warnings.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

namespace keyblock::support {

/// Returns each code that the sources (src, formats) can give a `Warning`, with a file that does. A code is the first
/// part of a braced list of name, place and sentence, or an argument of a function that makes warnings of it; both need
/// an underscore in the code. Codes of other forms are not found: of one word, or put together of parts, but those of
/// DDAML defaults are.
std::map<std::string, std::string> warning_codes();

/// The text of all sources but the table of diagnostics.
std::string source_text();

}  // namespace keyblock::support
