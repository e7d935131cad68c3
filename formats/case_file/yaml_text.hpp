// Reads a case file written as YAML into the tree of values that JSON gives.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/text/json_text.hpp"

namespace keyblock::formats {

/// Returns true if a text is a case file in YAML: a line begins with the key `keyblock:`.
bool is_yaml_case(std::string_view text);

/// Puts the one document of a YAML text into a tree without values (`JsonText::Unread`), with the place of every value.
/// Plain words are numbers, true, false or null by the core schema of YAML 1.2.2 (section 10.3.2). Octal, hexadecimal
/// and infinite numbers stay texts. Throws InputError for anchors, aliases, a second document, a text that is not
/// well-formed, or nesting deeper than any case file has.
void read_yaml(JsonText& into, const Source& source);

}  // namespace keyblock::formats
