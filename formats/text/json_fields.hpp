// The values of a JSON object by name and demand; unknown keys are refused.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "formats/text/placed_json.hpp"
#include "formats/text/tokens.hpp"

namespace keyblock::formats {

/// Views an object while it is read. Messages name the key and `noun`, what the object describes ("a joint set").
class JsonFields {
 public:
  /// Throws InputError where the value is no object or has a key that is not among `known`.
  JsonFields(const PlacedJson& object, std::string noun, const std::vector<std::string_view>& known);

  const Place& place() const { return object_.place; }
  bool has(std::string_view key) const { return value(key) != nullptr; }

  /// InputError where the value is no number, breaks the demand, or is absent and has no default.
  double real(std::string_view key, const Demand& demand, std::optional<double> absent = std::nullopt) const;
  int integer(std::string_view key, const Demand& demand, std::optional<int> absent = std::nullopt) const;
  /// The place of the value in `words`.
  std::size_t word(std::string_view key, const std::vector<std::string_view>& words, std::size_t absent) const;
  /// Null where absent.
  const PlacedJson* value(std::string_view key) const;
  /// The items of a list; none where absent.
  std::vector<PlacedJson> list(std::string_view key) const;
  /// Lists of so many numbers, in a list; none where absent.
  std::vector<std::vector<double>> rows(std::string_view key, std::size_t numbers) const;

 private:
  [[noreturn]] void refuse(const PlacedJson& value, std::string_view key, std::string_view expected) const;

  const PlacedJson& object_;
  std::string noun_;
};

}  // namespace keyblock::formats
