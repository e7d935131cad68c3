// Recognises files that it does not read, so that the error can name them.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Extended 1.5: first word begins `#!0xDDA`.
// Disk DDA (`.par`) [inferred]: 0, 1 or 2, then two reals between 0 and 1.
// UDEC (Itasca), a text of commands [its manuals and public decks]. A line begins with BLOCK and a number, a bracket,
// or a word such as SIZE or CREATE. Another line begins with ROUND, CRACK, JSET, PROP, BOUNDARY, … Letters have either
// case; `;` begins a comment.
#pragma once

#include "formats/format.hpp"

namespace keyblock::formats {

extern const Format kDdaExtended;
extern const Format kDiskDda;
extern const Format kUdecDeck;

}  // namespace keyblock::formats
