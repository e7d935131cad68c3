// The fields of one JSON value, taken one after another; what nobody takes, and what is missing, are errors.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "formats/text/json_text.hpp"

namespace keyblock::formats {

/// By key where the value is an object, in order where it is an array (a row).
class TakenFields {
 public:
  TakenFields(JsonValue value, std::string_view noun);
  /// Throws InputError at a key or value that no field has taken, then for the first key that is missing.
  void finish() const;

 protected:
  /// The value of the next field into `value_`; false where the object lacks it.
  bool take(std::string_view name);
  bool is_at_end_of_row() const { return in_row_ && *in_row_ == from_.end(); }
  /// Names a field that is not taken, for messages.
  void known(std::string_view name) { known_.push_back(name); }
  const JsonValue& of_kind(JsonKind kind, std::string_view name) const;
  /// For lists of lists: an empty one is so short that a vector that grows would take many times the file.
  static std::size_t size_of(const JsonValue& array);
  /// Of the list last asked for: there where it is needed, with `least` items.
  void require(std::string_view name, std::size_t size, std::optional<std::size_t> least);

  JsonValue from_;
  std::string_view noun_;
  std::optional<JsonValue> value_;       ///< last taken
  std::vector<std::string_view> known_;  ///< keys asked for
  std::string missing_;                  ///< what the first missing key should have been

 private:
  std::string nearest_of(std::string_view name) const;

  std::optional<JsonValue::Iterator> in_row_;  ///< next of a row
};

}  // namespace keyblock::formats
