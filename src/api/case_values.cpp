// Writes the case as a case file, changes the JSON, and reads it again.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "api/case_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "base/counted.hpp"
#include "base/nearest.hpp"
#include "formats/all_content.hpp"
#include "formats/case_file/keyblock_case.hpp"

namespace keyblock {
namespace {

using Json = nlohmann::ordered_json;
using Pointer = Json::json_pointer;

struct Found {
  Pointer at;
  const Json* value;  ///< null: a new key
};

std::invalid_argument no_value(std::string_view pointer, const std::string& why = {}) {
  return std::invalid_argument(
      fmt::format("expected a pointer to a value of the case, such as /analysis/time_step, found {}{}", pointer, why));
}

/// Names the part of a pointer that leads nowhere, and the nearest key or name.
std::string why_nowhere(const Found& place, const std::string& part) {
  const Json& whole = *place.value;
  const std::string at = place.at.empty() ? "the case" : place.at.to_string();
  std::vector<std::string> names;
  if (whole.is_object())
    for (const auto& [key, value] : whole.items()) names.push_back(key);
  else if (whole.is_array())
    for (const Json& item : whole)
      if (item.is_object() && item.contains("name") && item["name"].is_string())
        names.push_back(item["name"].get<std::string>());
  const std::string count =
      whole.is_array() ? fmt::format(", {} from 0,", counted(whole.size(), "item")) : std::string();
  return fmt::format(": {}{} has no {}{}", at, count, part, nearest_words(part, names));
}

bool is_item(const Json& item, std::size_t index, const std::string& part) {
  if (part == "*" || part == std::to_string(index)) return true;
  return item.is_object() && item.contains("name") && item["name"].is_string() && item["name"] == part;
}

void add_children(std::vector<Found>& found, const Found& place, const std::string& part, bool may_be_new) {
  if (place.value == nullptr) return;
  const Json& whole = *place.value;
  if (whole.is_object() && part != "*") {
    const auto child = whole.find(part);
    if (child != whole.end()) found.push_back({place.at / part, &*child});
    if (child == whole.end() && may_be_new) found.push_back({place.at / part, nullptr});
  } else if (whole.is_object()) {
    for (const auto& [key, value] : whole.items()) found.push_back({place.at / key, &value});
  } else if (whole.is_array()) {
    for (std::size_t i = 0; i < whole.size(); ++i)
      if (is_item(whole[i], i, part)) found.push_back({place.at / i, &whole[i]});
  }
}

/// Returns the schema of the value behind the steps; an empty one if the schema does not describe it.
Json schema_at(const Json& schema, const std::vector<std::string>& steps) {
  const Json* at = &schema;
  for (const std::string& step : steps) {
    const bool is_item = is_list_index(step) && !at->contains("properties");
    const std::size_t index = is_item ? std::stoul(step) : 0;
    const bool has_place = is_item && at->contains("prefixItems") && index < at->at("prefixItems").size();
    const Json* next = nullptr;
    if (has_place) next = &at->at("prefixItems").at(index);
    if (is_item && !has_place && at->contains("items")) next = &at->at("items");
    if (!is_item && at->contains("properties") && at->at("properties").contains(step))
      next = &at->at("properties").at(step);
    if (next == nullptr || !next->is_object()) return Json::object();
    at = next;
  }
  return *at;
}

/// Adds the place of a row that its key names: /blocks/bolts/0/pretension.
void add_row_place(std::vector<Found>& found, const Found& place, const std::string& part) {
  if (place.value == nullptr || !place.value->is_array()) return;
  const Json schema = schema_at(Json::parse(formats::case_schema()), pointer_steps(place.at.to_string()));
  const Json places = schema.value("prefixItems", Json::array());
  for (std::size_t i = 0; i < std::min(places.size(), place.value->size()); ++i)
    if (places[i].value("x-key", "") == part) found.push_back({place.at / i, &(*place.value)[i]});
}

std::vector<Found> places_in(const Json& json, std::string_view pointer, bool or_new) {
  std::vector<Found> found{{Pointer(), &json}};
  const std::vector<std::string> parts = pointer_steps(pointer);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    std::vector<Found> next;
    for (const Found& place : found) add_children(next, place, parts[i], or_new && i + 1 == parts.size());
    if (next.empty())
      for (const Found& place : found) add_row_place(next, place, parts[i]);
    if (next.empty()) throw no_value(pointer, why_nowhere(found.front(), parts[i]));
    found = std::move(next);
  }
  return found;
}

bool has_type(const Json& schema, const char* name) {
  const Json type = schema.value("type", Json());
  const Json types = type.is_array() ? type : Json::array({type});
  return std::ranges::find(types, name) != types.end();
}

bool is_whole(const Json& schema) {
  return has_type(schema, "integer") && !has_type(schema, "number");
}

WordKind words_of(const Json& schema) {
  if (!schema.contains("type")) return WordKind::amount;
  const bool has_number = has_type(schema, "number") || has_type(schema, "integer");
  if (has_type(schema, "string") && !has_number) return WordKind::name;
  return has_type(schema, "number") && schema.contains("x-unit") ? WordKind::amount : WordKind::plain;
}

}  // namespace

std::vector<std::string> pointer_steps(std::string_view pointer) {
  std::vector<std::string> parts;
  if (pointer.empty()) return parts;
  if (pointer.front() != '/') throw no_value(pointer);
  for (const char c : pointer) {
    if (c == '/')
      parts.emplace_back();
    else
      parts.back() += c;
  }
  for (std::string& part : parts)
    for (const auto& [code, character] : {std::pair{"~1", "/"}, std::pair{"~2", "="}, std::pair{"~0", "~"}})
      for (std::size_t at = part.find(code); at != std::string::npos; at = part.find(code, at + 1))
        part.replace(at, 2, character);
  return parts;
}

bool is_list_index(std::string_view step) {
  return !step.empty() && step.find_first_not_of("0123456789") == std::string_view::npos;
}

bool takes_whole_numbers(std::string_view pointer, const std::string& json) {
  const Json schema = Json::parse(formats::case_schema());
  const Json whole = Json::parse(json);
  return std::ranges::any_of(places_in(whole, pointer, true), [&](const Found& place) {
    return is_whole(schema_at(schema, pointer_steps(place.at.to_string())));
  });
}

std::string row_key_at(const std::string& pointer) {
  return schema_at(Json::parse(formats::case_schema()), pointer_steps(pointer)).value("x-key", "");
}

WordKind words_at(std::string_view pointer, const std::string& json) {
  const Json whole = Json::parse(json);
  const Found place = places_in(whole, pointer, true).front();
  return words_of(schema_at(Json::parse(formats::case_schema()), pointer_steps(place.at.to_string())));
}

WordKind words_of_setting(const std::string& name) {
  return words_of(schema_at(Json::parse(formats::case_schema()), {"run", "set", name}));
}

ChangedValue case_value_of(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (text.empty() || text.front() != '/' || equals == std::string::npos)
    throw std::invalid_argument(
        fmt::format("expected POINTER=VALUE, such as /analysis/time_step=0.01, found \"{}\"", text));
  return {text.substr(0, equals), text.substr(equals + 1)};
}

std::string text_of(const ChangedValue& value) {
  std::string text;
  for (const char c : value.pointer) text += c == '=' ? "~2" : std::string(1, c);
  return text + "=" + value.value;
}

std::vector<std::string> pointers_to(std::string_view pointer, const std::string& json, bool or_new) {
  std::vector<std::string> found;
  const Json whole = Json::parse(json);
  for (const Found& place : places_in(whole, pointer, or_new)) found.push_back(place.at.to_string());
  return found;
}

std::string value_at(std::string_view pointer, const std::string& json) {
  const Json whole = Json::parse(json);
  const std::vector<Found> places = places_in(whole, pointer, false);
  const std::vector<std::string> parts = pointer_steps(pointer);
  if (std::ranges::find(parts, "*") == parts.end()) return places.front().value->dump();
  Json all = Json::array();
  for (const Found& place : places) all.push_back(*place.value);
  return all.dump();
}

formats::Case with_values(const formats::Case& before, const std::vector<ChangedValue>& values) {
  Json json = Json::parse(formats::case_file_text(before.files));
  for (const ChangedValue& given : values) {
    const Json parsed = Json::parse(given.value, nullptr, false);
    const Json value = parsed.is_discarded() ? Json(given.value) : parsed;
    std::vector<Pointer> places;
    for (const Found& place : places_in(json, given.pointer, true)) places.push_back(place.at);
    for (const Pointer& place : places) json[place] = value;
  }
  formats::FileReading file;
  file.path = before.files.front().path + " (changed)";
  file.source = {file.path, json.dump(1)};
  file.choice = formats::recognise(file.source);
  file.reading = formats::read_as(*file.choice, file.source);
  file.reading->content.is_own_case = before.problem.has_own_case;
  formats::Case after = formats::case_of({std::move(file)});
  Warnings warnings = before.warnings;
  for (const Warning& warning : after.warnings)
    if (std::ranges::none_of(warnings, [&](const Warning& known) { return known.sentence == warning.sentence; }))
      warnings.push_back(warning);
  after.warnings = std::move(warnings);
  return after;
}

}  // namespace keyblock
