// Changes values of a case by their place in its case file.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A JSON pointer (RFC 6901) names a value: /analysis/joint_materials/0/friction_angle_deg. The name of a list item may
// replace its number (/analysis/joint_materials/bedding/friction_angle_deg), the key of a place that of a row
// (/blocks/bolts/0/pretension), and * stands for all items. ~2 stands for an equals sign in a name, which would end the
// pointer of "POINTER=VALUE".
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "formats/case.hpp"

namespace keyblock {

/// Value at a pointer: JSON, or a text that is not JSON, such as "50 kN".
struct ChangedValue {
  std::string pointer;
  std::string value;
};

/// Returns the parts of a pointer between slashes, with ~0, ~1 and ~2 replaced. Throws std::invalid_argument for a text
/// without a first slash.
std::vector<std::string> pointer_steps(std::string_view pointer);

/// Returns true if a step of a pointer is the number of a list item.
bool is_list_index(std::string_view step);

/// Returns true if the case file takes whole numbers alone at the pointer, in a case file in strict JSON.
bool takes_whole_numbers(std::string_view pointer, const std::string& json);

/// Returns the key of a place of a row, "pretension" of /blocks/bolts/0/8; empty for other places.
std::string row_key_at(const std::string& pointer);

/// Words of a value: a number that may have a unit, a number or a name, a name alone.
enum class WordKind { amount, plain, name };

/// Returns the words that the case file takes at the pointer; `amount` if its schema does not say. Throws like
/// `pointers_to`.
WordKind words_at(std::string_view pointer, const std::string& json);
WordKind words_of_setting(const std::string& name);

/// Parses "POINTER=VALUE". Throws std::invalid_argument.
ChangedValue case_value_of(const std::string& text);

/// Returns the text that `case_value_of` reads.
std::string text_of(const ChangedValue& value);

/// Returns the JSON pointers that a pointer with names and * stands for, in a case file in strict JSON. Throws
/// std::invalid_argument if there are none. With `or_new`, the last key may be missing in its object.
std::vector<std::string> pointers_to(std::string_view pointer, const std::string& json, bool or_new = false);

/// Returns the value at a pointer as JSON, or the list of values that * stands for. Throws std::invalid_argument if
/// there is none.
std::string value_at(std::string_view pointer, const std::string& json);

/// Returns the case with the values, in their order. Its one file, in the folder of the first, has the content of all.
/// Files of Shi's programs keep the rules that belong to them. Throws std::invalid_argument for a pointer to nothing,
/// InputError for a value that the file must not have.
formats::Case with_values(const formats::Case& before, const std::vector<ChangedValue>& values);

}  // namespace keyblock
