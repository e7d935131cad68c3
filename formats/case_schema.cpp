// The visitor that writes down the layout itself, as JSON Schema: what `describe` names can be checked by other programs too.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>

#include "formats/case_fields.hpp"
#include "formats/keyblock_case.hpp"

namespace keyblock::formats {
namespace {

using Json = nlohmann::ordered_json;

/// Describes one struct: as an object with keys, or as a row, whose places are named.
class CaseSchema {
 public:
  static constexpr bool is_writing = false;

  void real(std::string_view name, double&, const Demand& demand = kAny) { add(name, number("number", demand)); }
  template <class Integer>
  void integer(std::string_view name, Integer&, const Demand& demand) {
    add(name, number("integer", demand));
  }
  void index(std::string_view name, int&) { add(name, {{"type", "integer"}, {"description", "counted from 1"}}); }
  void flag(std::string_view name, bool&) { add(name, {{"type", "boolean"}}); }
  void text(std::string_view name, std::string&) { add(name, {{"type", "string"}}); }
  template <class Enum>
  void word(std::string_view name, Enum&, std::span<const std::string_view> words) {
    add(name, {{"enum", std::vector<std::string>(words.begin(), words.end())}});
  }
  void optional_real(std::string_view name, std::optional<double>&, const Demand& demand) {
    add(name, number("number", demand));
  }
  void optional_integer(std::string_view name, std::optional<int>&, const Demand& demand) {
    add(name, number("integer", demand));
  }
  template <class T>
  void row(std::string_view name, T&) {
    add(name, row_of<T>());
  }
  template <class T>
  void object(std::string_view name, T&) {
    add(name, object_of<T>());
  }
  template <class T>
  void optional_object(std::string_view name, std::optional<T>&) {
    add(name, object_of<T>());
  }
  template <class T>
  void rows(std::string_view name, std::vector<T>&) {
    add(name, list_of(row_of<T>()));
  }
  template <class T>
  void objects(std::string_view name, std::vector<T>&) {
    add(name, list_of(object_of<T>()));
  }
  template <class T>
  void lists(std::string_view name, std::vector<std::vector<T>>&) {
    add(name, list_of(list_of(row_of<T>())));
  }
  void curve(std::string_view name, TimeCurve&) { add(name, list_of(curve_row())); }
  void optional_curve(std::string_view name, std::optional<TimeCurve>&) { add(name, list_of(curve_row())); }
  void curves(std::string_view name, std::vector<TimeCurve>&) { add(name, list_of(list_of(curve_row()))); }
  void pairs(std::string_view name, std::vector<std::pair<std::string, std::string>>&) {
    add(name, {{"type", "object"}, {"additionalProperties", {{"type", "string"}}}});
  }

  template <class T>
  static Json object_of() {
    const CaseSchema parts = of<T>();
    return {{"type", "object"}, {"properties", parts.keys_}, {"additionalProperties", false}};
  }

 private:
  template <class T>
  static CaseSchema of() {
    CaseSchema parts;
    T sample{};
    describe(parts, sample);
    return parts;
  }
  template <class T>
  static Json row_of() {
    return row_of(of<T>());
  }
  static Json row_of(const CaseSchema& parts) {
    Json places = Json::array();
    for (const auto& [name, schema] : parts.keys_.items()) {
      Json place = schema;
      place["title"] = name;
      places.push_back(place);
    }
    return {{"type", "array"}, {"prefixItems", places}, {"minItems", places.size()}, {"items", false}};
  }
  static Json curve_row() {
    CaseSchema parts;
    double number = 0;
    for (const char* name : {"time", "x", "y"}) parts.real(name, number);
    return row_of(parts);
  }
  static Json list_of(Json item) { return {{"type", "array"}, {"items", std::move(item)}}; }
  static Json number(const char* type, const Demand& demand) {
    return {{"type", type}, {"description", std::string(demand.wording)}};
  }
  void add(std::string_view name, Json schema) { keys_[std::string(name)] = std::move(schema); }

  Json keys_ = Json::object();
};

}  // namespace

std::string case_schema() {
  Json schema = CaseSchema::object_of<Content>();
  schema["properties"]["keyblock"] = {{"const", kCaseVersion}};
  schema["required"] = {"keyblock"};
  Json head = {{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", "Keyblock case file"}};
  head.update(schema);
  return head.dump(1) + "\n";
}

}  // namespace keyblock::formats
