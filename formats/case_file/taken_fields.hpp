// Takes the fields of one JSON value in turn; fields that are not taken, and missing ones, are errors.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "formats/text/json_text.hpp"

namespace keyblock::formats {

/// Fields of a value: by key in an object, in order in an array (a row).
class TakenFields {
 public:
  TakenFields(JsonValue value, std::string_view noun);
  /// Throws InputError at a key or value that was not taken, then for the first missing key.
  void finish() const;

 protected:
  /// Moves the value of the next field into `value_`; returns false if the object lacks it.
  bool take(std::string_view name);
  bool is_at_end_of_row() const { return in_row_ && *in_row_ == from_.end(); }
  /// Names a field that is not taken, for messages.
  void known(std::string_view name) { known_.push_back(name); }
  const JsonValue& of_kind(JsonKind kind, std::string_view name) const;
  /// Returns the number of items, for lists of lists: an empty one is so short that a growing vector would take many
  /// times the size of the file.
  static std::size_t size_of(const JsonValue& array);
  /// Checks the list requested last: it must exist if required, with at least `least` items.
  void require(std::string_view name, std::size_t size, std::optional<std::size_t> least);

  JsonValue from_;
  std::string_view noun_;
  std::optional<JsonValue> value_;       ///< last taken
  std::vector<std::string_view> known_;  ///< requested keys
  std::string missing_;                  ///< expected content of the first missing key

 private:
  std::string nearest_of(std::string_view name) const;

  std::optional<JsonValue::Iterator> in_row_;  ///< next of a row
};

}  // namespace keyblock::formats
