// Walks the tree of values and passes it to the JSON writer.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/strict_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "formats/case_file/yaml_text.hpp"
#include "formats/text/json_text.hpp"

namespace keyblock::formats {
namespace {

using Json = nlohmann::ordered_json;

// Whole numbers that a double holds exactly are written without a point.
Json number_of(double value) {
  constexpr double kLargestExact = 9007199254740992;  // 2^53
  if (value == std::floor(value) && std::abs(value) <= kLargestExact) return static_cast<long long>(value);
  return value;
}

Json tree_of(const JsonValue& value) {
  switch (value.kind()) {
    case JsonKind::null:
      return nullptr;
    case JsonKind::no:
      return false;
    case JsonKind::yes:
      return true;
    case JsonKind::number:
      return number_of(value.number());
    case JsonKind::string:
      return std::string(value.string());
    case JsonKind::array: {
      Json list = Json::array();
      for (const JsonValue item : value) list.push_back(tree_of(item));
      return list;
    }
    case JsonKind::object:
      break;
  }
  Json object = Json::object();
  std::optional<std::string> key;
  for (const JsonValue item : value) {
    if (!key) {
      key = std::string(item.string());
      continue;
    }
    object[*key] = tree_of(item);
    key.reset();
  }
  return object;
}

}  // namespace

std::string strict_json(const Source& source) {
  std::optional<JsonText> text;
  if (is_yaml_case(source.text))
    read_yaml(text.emplace(source, JsonText::Unread{}), source);
  else
    text.emplace(source);
  return tree_of(text->root()).dump(2) + "\n";
}

}  // namespace keyblock::formats
