// Reads the values of a JSON object by name, checks them, and rejects unknown keys.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "formats/text/placed_json.hpp"
#include "formats/text/tokens.hpp"

namespace keyblock::formats {

/// View of an object while it is read. Messages name the key and `noun`, the object described ("a joint set").
class JsonFields {
 public:
  /// Throws InputError if the value is not an object or has a key that is not among `known`.
  JsonFields(const PlacedJson& object, std::string noun, const std::vector<std::string_view>& known);

  const Place& place() const { return object_.place; }
  bool has(std::string_view key) const { return value(key) != nullptr; }

  /// Throws InputError if the value is not a number, violates the demand, or is absent and has no default.
  double real(std::string_view key, const Demand& demand, std::optional<double> absent = std::nullopt) const;
  int integer(std::string_view key, const Demand& demand, std::optional<int> absent = std::nullopt) const;
  /// Returns the index of the value in `words`.
  std::size_t word(std::string_view key, const std::vector<std::string_view>& words, std::size_t absent) const;
  /// Returns null if absent.
  const PlacedJson* value(std::string_view key) const;
  /// Returns the items of a list; empty if absent.
  std::vector<PlacedJson> list(std::string_view key) const;
  /// Returns lists of `numbers` numbers each, in a list; empty if absent.
  std::vector<std::vector<double>> rows(std::string_view key, std::size_t numbers) const;

 private:
  [[noreturn]] void refuse(const PlacedJson& value, std::string_view key, std::string_view expected) const;

  const PlacedJson& object_;
  std::string noun_;
};

}  // namespace keyblock::formats
