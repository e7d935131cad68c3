// Writes the layout as JSON Schema, as a visitor: other programs can check the keys that `describe` names.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "formats/case_file/case_fields.hpp"
#include "formats/case_file/case_meanings.hpp"
#include "formats/case_file/case_measures.hpp"
#include "formats/case_file/case_values.hpp"
#include "formats/case_file/keyblock_case.hpp"
#include "formats/case_file/material_library.hpp"
#include "formats/case_file/schema/case_titles.hpp"
#include "formats/case_file/schema/limits.hpp"
#include "formats/case_file/schema/setting_schema.hpp"
#include "problem/units/unit_names.hpp"
#include "settings/profile.hpp"

namespace keyblock::formats {
namespace {

using Json = nlohmann::ordered_json;

// Values of the library need not be given.
constexpr const char* kLike = "like";
// Number and unit, as `quantity_in` splits them.
constexpr const char* kValueWithUnit = R"(^-?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)? *[^ ]+ *$)";
constexpr const char* kPerCent = R"(^-?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)? *[%‰] *$)";

/// Describes one struct: as an object with keys, or as a row with named places.
class CaseSchema {
 public:
  static constexpr bool is_writing = false;

  explicit CaseSchema(std::string_view parent) : parent_(parent) {}

  void real(std::string_view name, double& value, const Demand& demand = kAny) {
    add_number(name, "number", demand, value, demand.holds(value));
  }
  template <class Integer>
  void integer(std::string_view name, Integer& value, const Demand& demand) {
    add_number(name, "integer", demand, value, demand.holds(static_cast<double>(value)));
  }
  void index(std::string_view name, int& value) {
    Json type = "integer";
    if (takes_name(name)) type = {"integer", "string"};
    add(name, {{"type", type}, {"default", value + 1}});
  }
  void optional_index(std::string_view name, std::optional<int>&) {
    Json type = "integer";
    if (takes_name(name)) type = {"integer", "string"};
    add(name, {{"type", type}}, kAtLeastOne);
  }
  template <class T>
  void optional_row(std::string_view name, std::optional<T>&) {
    add(name, row_of<T>(name));
  }
  void flag(std::string_view name, bool& value) { add(name, {{"type", "boolean"}, {"default", value}}); }
  void text(std::string_view name, std::string&) { add(name, {{"type", "string"}}); }
  void name_at_end(std::string_view name, Rare<std::string>&) {
    add(name, {{"type", "string"}, {"minLength", 1}});
    ++places_that_may_lack_;
  }
  void mass_by(std::string_view force, std::string_view stress, Units&) {
    const auto put = [&](std::string_view name, std::span<const std::string_view> known) {
      add(name, {{"type", "string"}, {"enum", std::vector<std::string>(known.begin(), known.end())}});
    };
    put(force, kForceUnits);
    put(stress, kStressUnits);
  }
  void formula(std::string_view name, Formula&) { add(name, {{"type", {"number", "string"}}, {"default", 0}}); }
  void optional_formula(std::string_view name, std::optional<Formula>&) { add(name, {{"type", {"number", "string"}}}); }
  template <class Enum>
  void word(std::string_view name, Enum& value, std::span<const std::string_view> words) {
    add(name, {{"enum", std::vector<std::string>(words.begin(), words.end())},
               {"default", std::string(words[static_cast<std::size_t>(value)])}});
  }
  template <class Enum>
  void optional_word(std::string_view name, std::optional<Enum>&, std::span<const std::string_view> words) {
    add(name, {{"enum", std::vector<std::string>(words.begin(), words.end())}});
  }
  void optional_real(std::string_view name, std::optional<double>&, const Demand& demand) {
    add(name, number_of(name, "number"), demand);
  }
  void optional_integer(std::string_view name, std::optional<int>&, const Demand& demand) {
    add(name, {{"type", "integer"}}, demand);
  }
  template <class T>
  void row(std::string_view name, T&) {
    add(name, row_of<T>(name));
  }
  template <class T>
  void object(std::string_view name, T&) {
    add(name, object_of<T>(name));
  }
  template <class T>
  void optional_object(std::string_view name, std::optional<T>&, const T& /*start*/ = {}) {
    add(name, object_of<T>(name));
  }
  void name(std::string_view name) { add(name, {{"type", "string"}}); }
  template <class Material>
  void of_library(std::string_view name, Material& material) {
    add(name, {{"type", "string"}, {"enum", library_names(material)}});
  }
  template <class T>
  void object_or_file(std::string_view name, std::optional<T>&, std::string&, Place&) {
    Json object = object_of<T>(name);
    object["type"] = {"object", "string"};
    add(name, std::move(object));
  }
  static Analysis start_of_analysis() { return {}; }
  template <class T>
  void rows(std::string_view name, std::vector<T>&, std::optional<std::size_t> least = std::nullopt) {
    add_list(name, list_of(row_of<T>(name)), least);
  }
  template <class T>
  void objects(std::string_view name, std::vector<T>&) {
    add(name, list_of(object_of<T>(name)));
  }
  template <class T>
  void lists(std::string_view name, std::vector<std::vector<T>>&, std::optional<std::size_t> least = std::nullopt) {
    add_list(name, list_of(list_of(row_of<T>(name))), least);
  }
  void curve(std::string_view name, TimeCurve&) { add(name, list_of(curve_row(name))); }
  void optional_curve(std::string_view name, std::optional<TimeCurve>&) { add(name, list_of(curve_row(name))); }
  void curves(std::string_view name, std::vector<TimeCurve>&) { add(name, list_of(list_of(curve_row(name)))); }
  void pairs(std::string_view name, std::vector<std::pair<std::string, std::string>>&) {
    if (name != kSettings) return add(name, {{"type", "object"}, {"additionalProperties", {{"type", "string"}}}});
    const Json other = {{"type", {"string", "number", "boolean"}}};
    add(name, {{"type", "object"}, {"properties", setting_properties()}, {"additionalProperties", other}});
  }

  /// `parent`: key of this value.
  template <class T>
  static Json object_of(std::string_view parent) {
    const CaseSchema parts = of<T>(parent);
    Json object = {{"type", "object"}, {"properties", parts.keys_}};
    if (parts.keys_.contains(kLike) && !parts.required_.empty())
      object["anyOf"] = Json::array({{{"required", Json::array({kLike})}}, {{"required", parts.required_}}});
    else if (!parts.required_.empty())
      object["required"] = parts.required_;
    object["additionalProperties"] = false;
    return object;
  }

 private:
  template <class T>
  static CaseSchema of(std::string_view parent) {
    CaseSchema parts(parent);
    T sample{};
    describe(parts, sample);
    return parts;
  }
  template <class T>
  static Json row_of(std::string_view parent) {
    return row_of(of<T>(parent));
  }
  /// Every place of a row is required except a name at its end.
  static Json row_of(const CaseSchema& parts) {
    Json places = Json::array();
    for (const auto& [name, schema] : parts.keys_.items()) {
      Json place = schema;
      place["x-key"] = name;
      place.erase("default");
      places.push_back(place);
    }
    return {{"type", "array"},
            {"prefixItems", places},
            {"minItems", places.size() - parts.places_that_may_lack_},
            {"items", false}};
  }
  static Json curve_row(std::string_view parent) {
    CaseSchema parts(parent);
    double number = 0;
    for (const char* name : {"time", "x", "y"}) parts.real(name, number);
    return row_of(parts);
  }
  static Json list_of(Json item) { return {{"type", "array"}, {"items", std::move(item)}}; }

  /// A number without a permitted default is required.
  template <class Number>
  void add_number(std::string_view name, const char* type, const Demand& demand, Number value, bool has_default) {
    Json number = number_of(name, type);
    if (has_default)
      number["default"] = value;
    else
      required_.emplace_back(name);
    add(name, std::move(number), demand);
  }
  /// Matches the reader: a number with a unit may be a text with a number and a unit.
  Json number_of(std::string_view name, const char* type) const {
    if (takes_per_cent(parent_, name)) return {{"type", {type, "string"}}, {"pattern", kPerCent}};
    if (!takes_unit(parent_, name)) return {{"type", type}};
    return {{"type", {type, "string"}}, {"pattern", kValueWithUnit}};
  }
  void add_list(std::string_view name, Json list, std::optional<std::size_t> least) {
    if (least) required_.emplace_back(name);
    if (least.value_or(0) > 0) list["minItems"] = *least;
    add(name, std::move(list));
  }
  void add(std::string_view name, Json schema, const Demand& demand = kAny) {
    const std::string_view meaning = meaning_of(parent_, name);
    const bool has_limits = demand.whole || demand.range.is_bounded();
    schema["title"] = title_of(parent_, name);
    schema["description"] =
        has_limits ? fmt::format("{}. Permitted: {}", meaning, demand.wording) : std::string(meaning);
    schema["x-group"] = group_of(parent_, name);
    if (has_limits) {
      schema["x-permitted"] = demand.wording;
      put_limits(schema, demand.range);
    }
    if (takes_unit(parent_, name))
      schema["examples"] = Json::array({example_value(measure_of(parent_, name).value_or(measures::kNumber))});
    if (is_number(schema)) {
      const Measure measure = measure_of(parent_, name).value_or(measures::kNumber);
      const std::string unit = unit_of(measure, Units{});
      schema["x-unit"] = unit.empty() ? "none" : unit;
      if (measure.of_slice) schema["x-of-slice"] = true;
    }
    for (const Json& word : schema.value("enum", Json::array()))
      if (const std::string_view said = meaning_of_word(name, word.get<std::string>()); !said.empty())
        schema["x-words"][word.get<std::string>()] = said;
    keys_[std::string(name)] = std::move(schema);
  }
  static bool is_number(const Json& schema) {
    const Json types = schema.value("type", Json());
    const auto is = [](const Json& type) { return type == "number" || type == "integer"; };
    return types.is_array() ? std::ranges::any_of(types, is) : is(types);
  }

  std::string_view parent_;
  Json keys_ = Json::object();
  std::vector<std::string> required_;
  std::size_t places_that_may_lack_ = 0;  ///< at the end of a row
};

void name_units(Json& units) {
  const auto name = [&](const char* key, std::span<const std::string_view> known) {
    units["properties"][key]["enum"] = std::vector<std::string>(known.begin(), known.end());
  };
  name("length", kLengthUnits);
  name("mass", kMassUnits);
  name("time", kTimeUnits);
  // A product is allowed too: `convert` writes one if the case declares a force instead.
  Json& mass = units["properties"]["mass"];
  mass["anyOf"] = Json::array({{{"enum", mass["enum"]}}, {{"pattern", "·"}}});
  mass.erase("enum");
}

// Removes the requirements that version 2 does not have.
void leave_to_version_1(Json& schema, const std::string& key) {
  Json& required = schema["properties"]["analysis"]["required"];
  Json others = Json::array();
  for (const Json& name : required)
    if (name != key) others.push_back(name);
  required = others;
  schema["if"] = {{"properties", {{"keyblock", {{"const", kCaseVersion}}}}}};
  schema["then"] = {{"properties", {{"analysis", {{"required", Json::array({key})}}}}}};
}

Json sections() {
  Json all = Json::array();
  for (const CaseSection& section : case_sections()) {
    Json path = Json::array();
    if (!section.parent.empty()) path.push_back(section.parent);
    path.push_back(section.key);
    all.push_back({{"title", section.title}, {"row", section.row}, {"path", path}});
  }
  return all;
}

}  // namespace

std::string case_schema() {
  Json schema = CaseSchema::object_of<Content>("case");
  Json& keys = schema["properties"];
  name_units(keys["units"]);
  keys["drawing"]["properties"]["edge_node_ratio"]["default"] = kDefaultEdgeNodeRatio;
  keys["keyblock"] = {{"enum", {kCaseVersion, kCaseVersionOfToday}},
                      {"title", title_of("case", "keyblock")},
                      {"description", "version of the layout; 2 has the current defaults"},
                      {"x-group", group_of("case", "keyblock")}};
  for (Json* own : {&keys["run"], &keys["stages"]["items"]})
    (*own)["properties"]["profile"]["examples"] = profile_names();
  schema["required"] = {"keyblock"};
  leave_to_version_1(schema, "allowed_displacement_ratio");
  Json head = {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
               {"title", "Keyblock case file"},
               {"x-sections", sections()}};
  head.update(schema);
  return head.dump(1) + "\n";
}

}  // namespace keyblock::formats
