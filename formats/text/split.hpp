// Splits a text into words and numbers, a long one on several threads.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "formats/text/tokens.hpp"

namespace keyblock::formats {

/// Returns the tokens of a text, the same for any number of `threads`; 0: chosen by its length.
Tokens tokenise(const Source& source, std::size_t threads = 0);

/// Adds the words of a piece of `tokens.text` that lies after the existing ones.
void add_words(Tokens& tokens, std::size_t first, std::size_t size);

/// Reads a text with a reader of tokens.
template <Reading (*ReadTokens)(const Tokens&, const ReadHint&)>
Reading read_split(const Source& source, const ReadHint& hint) {
  return ReadTokens(tokenise(source), hint);
}

}  // namespace keyblock::formats
