// What the keys of a case file mean, for the schema.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

namespace keyblock::formats {

/// A key, with the key that it stands under where that decides ("units.length"; "case" is the whole file), and its
/// meaning with the unit: L length, M mass, T time, F force, all per unit thickness.
struct CaseMeaning {
  std::string_view key;
  std::string_view meaning;
};

std::span<const CaseMeaning> case_meanings();

/// The meaning of `key` under `parent`; empty where the table has none.
std::string_view meaning_of(std::string_view parent, std::string_view key);

}  // namespace keyblock::formats
