// Suggests the correct name for a misspelt one.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

/// Returns the number of letters to insert, remove, replace or swap with the next one that turns `a` into `b` (Damerau
/// 1964, each place changed once).
std::size_t edit_distance(std::string_view a, std::string_view b);

/// Returns the name with the fewest changes, the first of equals; empty if more than a third of its letters would
/// change.
std::string nearest(std::string_view name, const std::vector<std::string>& names);

/// Returns `; did you mean "…"?`, or an empty text.
std::string nearest_words(std::string_view name, const std::vector<std::string>& names);

/// Returns `expected one of A, B, found "…"` with the nearest name, or an empty text if the name is one of them.
std::string unless_one_of(std::string_view name, const std::vector<std::string>& names);

}  // namespace keyblock
