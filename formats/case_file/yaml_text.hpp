// A case file written as YAML, as the same tree of values that JSON gives.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/text/json_text.hpp"

namespace keyblock::formats {

/// Whether a text is a case file in YAML: a line begins with the key `keyblock:`.
bool is_yaml_case(std::string_view text);

/// Puts the one document of a YAML text into a tree without values (`JsonText::Unread`), with the place of every value.
/// Plain words are numbers, true, false or null as the core schema of YAML 1.2.2 has them (section 10.3.2), less octal,
/// hexadecimal and infinite numbers, which stay texts. Anchors, aliases and a second document are refused. Throws
/// InputError where the text is not well-formed or nests deeper than any case file does.
void read_yaml(JsonText& into, const Source& source);

}  // namespace keyblock::formats
