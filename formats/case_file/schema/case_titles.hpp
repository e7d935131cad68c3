// Declares titles, groups and meanings of words of a case file, for the forms of other programs.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace keyblock::formats {

/// Returns the meaning of `key` under `parent`; empty if the table has none.
std::string_view meaning_of(std::string_view parent, std::string_view key);

/// Returns a title of `key` under `parent` for people: "Young's modulus". Keys without a row in the table are spelt
/// out.
std::string title_of(std::string_view parent, std::string_view key);

/// Returns the group of `key` among the keys of `parent`: "Contact".
std::string_view group_of(std::string_view parent, std::string_view key);

/// Returns the meaning of a permitted word of `key`; empty if the table has none.
std::string_view meaning_of_word(std::string_view key, std::string_view word);

/// Section of a form: its title and the key of the file that holds it, below `analysis` or not.
struct CaseSection {
  std::string_view title;
  std::string_view row;  ///< noun for one row of a list: "joint material"
  std::string_view parent;
  std::string_view key;
};

/// Returns the sections that users edit, in the order of work.
std::span<const CaseSection> case_sections();

}  // namespace keyblock::formats
