// Declares the keys of a specification of joint sets: titles, units, limits and meanings, for the reader and for forms.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "formats/text/tokens.hpp"

namespace keyblock::formats {

/// Key of an object of the specification.
struct JointKey {
  std::string_view parent;  ///< specification, rectangle, slope, tunnel or set
  std::string_view key;
  std::string_view title;
  std::string_view unit;     ///< L (length), deg or none; empty: not a number
  const Demand* demand;      ///< limits of a number; null: not a number
  std::string_view absent;   ///< default: a number, a word, or a sentence; empty: none
  bool is_required = false;  ///< by its object
  std::string_view meaning;
};

/// Permitted word and its meaning.
struct JointWord {
  std::string_view key;  ///< also of keys that end in it: distribution, trace_distribution
  std::string_view word;
  std::string_view meaning;
};

std::span<const JointKey> joint_keys();

/// Returns the keys of an object, in the order of the table.
std::vector<std::string_view> joint_keys_of(std::string_view parent);

/// Returns the limits of a number. Throws std::logic_error if the table has no such number.
const Demand& joint_demand(std::string_view parent, std::string_view key);

/// Returns the permitted words of a key, in the order of the table.
std::vector<std::string_view> joint_words_of(std::string_view key);

/// Returns the JSON Schema of the specification, with a line break at its end.
std::string joint_schema();

}  // namespace keyblock::formats
