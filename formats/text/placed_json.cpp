// Copies the values of a JSON text into a tree, and makes such trees from options.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/text/placed_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "formats/text/json_text.hpp"
#include "formats/text/numbers.hpp"
#include "formats/text/tokens.hpp"

namespace keyblock::formats {
namespace {

using Kind = PlacedJson::Kind;

PlacedJson placed(const JsonValue& value, const Place& place);

/// Returns `list` with the values inside it.
PlacedJson list_of(const JsonValue& value, PlacedJson list) {
  for (const JsonValue item : value) list.items.push_back(placed(item, item.place()));
  return list;
}

/// Returns `object` with its keys and their values, each at the place of its key.
PlacedJson object_of(const JsonValue& value, PlacedJson object) {
  for (auto i = value.begin(); i != value.end(); ++i) {
    const JsonValue name = *i;
    std::string key(name.string());
    if (std::ranges::find(object.keys, key) != object.keys.end())
      throw InputError(name.place(), fmt::format("expected each key once, found {} a second time", in_quotes(key)));
    object.keys.push_back(std::move(key));
    object.items.push_back(placed(*++i, name.place()));
  }
  return object;
}

PlacedJson placed(const JsonValue& value, const Place& place) {
  switch (value.kind()) {
    case JsonKind::null:
      return {Kind::null, "null", 0, {}, {}, place};
    case JsonKind::no:
      return {Kind::flag, "false", 0, {}, {}, place};
    case JsonKind::yes:
      return {Kind::flag, "true", 0, {}, {}, place};
    case JsonKind::number:
      return {Kind::number, format_real(value.number()), value.number(), {}, {}, place};
    case JsonKind::string:
      return {Kind::text, std::string(value.string()), 0, {}, {}, place};
    case JsonKind::array:
      return list_of(value, {Kind::list, "a list", 0, {}, {}, place});
    case JsonKind::object:
      return object_of(value, {Kind::object, "an object", 0, {}, {}, place});
  }
  return {};
}

}  // namespace

PlacedJson read_json(const Source& source) {
  const JsonText text(source);
  return placed(text.root(), text.root().place());
}

PlacedJson json_of_word(const std::string& name, std::string_view word) {
  PlacedJson value{Kind::text, std::string(word), 0, {}, {}, {name}};
  if (const auto number = parse_real(word)) {
    value.kind = Kind::number;
    value.number = *number;
  }
  return value;
}

PlacedJson json_of_option(const std::string& name, std::string_view text) {
  PlacedJson object{Kind::object, "an object", 0, {}, {}, {name}};
  while (!text.empty()) {
    const std::string_view part = text.substr(0, text.find(','));
    text.remove_prefix(std::min(part.size() + 1, text.size()));
    const std::size_t equals = part.find('=');
    if (equals == std::string_view::npos || equals == 0)
      throw InputError({name}, fmt::format("expected key=value, found {}", in_quotes(part)));
    const std::string key(part.substr(0, equals));
    if (std::ranges::find(object.keys, key) != object.keys.end())
      throw InputError({name}, fmt::format("expected each key once, found {} a second time", in_quotes(key)));
    object.keys.push_back(key);
    object.items.push_back(json_of_word(name, part.substr(equals + 1)));
  }
  return object;
}

}  // namespace keyblock::formats
