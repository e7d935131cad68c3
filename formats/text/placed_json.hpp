// A tree of named values with their places, from a JSON text or from an option of the command line.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "formats/format.hpp"

namespace keyblock::formats {

/// A value and where its key stands; without a key, where it stands itself.
struct PlacedJson {
  enum class Kind { null, flag, number, text, list, object };
  Kind kind = Kind::null;
  std::string text;               ///< as a message shows it; a text without its quotes
  double number = 0;              ///< of a number
  std::vector<PlacedJson> items;  ///< of a list or an object
  std::vector<std::string> keys;  ///< of an object: one an item, none twice
  Place place;
};

/// The value of a JSON text, with comments as in C++. Throws InputError as JsonText does, and where a key is repeated.
PlacedJson read_json(const Source& source);

/// An object from `key=value,key=value`. `name` is the option's, for messages. Throws InputError.
PlacedJson json_of_option(const std::string& name, std::string_view text);

/// A number where the word is one, else a text.
PlacedJson json_of_word(const std::string& name, std::string_view word);

}  // namespace keyblock::formats
