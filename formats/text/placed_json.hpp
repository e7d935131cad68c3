// Holds a tree of named values with their places, from a JSON text or from an option of the command line.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "formats/format.hpp"

namespace keyblock::formats {

/// Value and the place of its key; without a key, its own place.
struct PlacedJson {
  enum class Kind { null, flag, number, text, list, object };
  Kind kind = Kind::null;
  std::string text;               ///< as in messages; a text without its quotes
  double number = 0;              ///< of a number
  std::vector<PlacedJson> items;  ///< of a list or an object
  std::vector<std::string> keys;  ///< of an object: one per item, no duplicates
  Place place;
};

/// Reads the value of a JSON text, with comments as in C++. Throws InputError like JsonText, and for a repeated key.
PlacedJson read_json(const Source& source);

/// Makes an object from `key=value,key=value`. `name` is that of the option, for messages. Throws InputError.
PlacedJson json_of_option(const std::string& name, std::string_view text);

/// Returns a number if the word is one, otherwise a text.
PlacedJson json_of_word(const std::string& name, std::string_view word);

}  // namespace keyblock::formats
