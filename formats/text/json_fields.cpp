// Looks up keys of a JSON object and checks their values.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/text/json_fields.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

namespace keyblock::formats {

using Kind = PlacedJson::Kind;

JsonFields::JsonFields(const PlacedJson& object, std::string noun, const std::vector<std::string_view>& known)
    : object_(object), noun_(std::move(noun)) {
  if (object.kind != Kind::object)
    throw InputError(object.place, fmt::format("expected an object for {}, found {}", noun_, object.text));
  for (std::size_t i = 0; i < object.keys.size(); ++i)
    if (std::ranges::find(known, object.keys[i]) == known.end())
      throw InputError(object.items[i].place, fmt::format("expected one of the keys {} in {}, found {}",
                                                          fmt::join(known, ", "), noun_, in_quotes(object.keys[i])));
}

const PlacedJson* JsonFields::value(std::string_view key) const {
  const auto found = std::ranges::find(object_.keys, key);
  return found == object_.keys.end() ? nullptr : &object_.items[static_cast<std::size_t>(found - object_.keys.begin())];
}

void JsonFields::refuse(const PlacedJson& value, std::string_view key, std::string_view expected) const {
  const std::string found = value.kind == Kind::text ? in_quotes(value.text) : value.text;
  throw InputError(value.place, fmt::format("expected {} of {} ({}), found {}", key, noun_, expected, found));
}

double JsonFields::real(std::string_view key, const Demand& demand, std::optional<double> absent) const {
  const PlacedJson* found = value(key);
  if (found == nullptr && absent) return *absent;
  if (found == nullptr)
    throw InputError(object_.place, fmt::format("expected {} of {} ({}), found none", key, noun_, demand.wording));
  if (found->kind != Kind::number || !demand.holds(found->number)) refuse(*found, key, demand.wording);
  return found->number;
}

int JsonFields::integer(std::string_view key, const Demand& demand, std::optional<int> absent) const {
  return static_cast<int>(real(key, demand, absent));
}

std::size_t JsonFields::word(std::string_view key, const std::vector<std::string_view>& words,
                             std::size_t absent) const {
  const PlacedJson* found = value(key);
  if (found == nullptr) return absent;
  const auto at = std::ranges::find(words, found->text);
  if (found->kind != Kind::text || at == words.end())
    refuse(*found, key, fmt::format("one of {}", fmt::join(words, ", ")));
  return static_cast<std::size_t>(at - words.begin());
}

std::vector<PlacedJson> JsonFields::list(std::string_view key) const {
  const PlacedJson* found = value(key);
  if (found == nullptr) return {};
  if (found->kind != Kind::list) refuse(*found, key, "a list");
  return found->items;
}

std::vector<std::vector<double>> JsonFields::rows(std::string_view key, std::size_t numbers) const {
  std::vector<std::vector<double>> rows;
  for (const PlacedJson& item : list(key)) {
    const auto is_number = [](const PlacedJson& value) { return value.kind == Kind::number; };
    if (item.kind != Kind::list || item.items.size() != numbers || !std::ranges::all_of(item.items, is_number))
      refuse(item, key, fmt::format("lists of {} numbers", numbers));
    rows.emplace_back();
    for (const PlacedJson& value : item.items) rows.back().push_back(value.number);
  }
  return rows;
}

}  // namespace keyblock::formats
