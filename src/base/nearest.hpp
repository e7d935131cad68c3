// What a misspelt name was meant to be.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

/// Letters to put in, take out, exchange or swap with the next one that make `a` of `b` (Damerau 1964, each place
/// changed once).
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The name fewest changes away; empty where more than a third of its letters would change. Of equals the first.
std::string nearest(std::string_view name, const std::vector<std::string>& names);

/// `; did you mean "…"?`, or nothing.
std::string nearest_words(std::string_view name, const std::vector<std::string>& names);

}  // namespace keyblock
