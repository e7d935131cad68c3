// Writes and reads rows field by field.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/batch/batch_catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/printable.hpp"

namespace keyblock::study {
namespace {

using Json = nlohmann::ordered_json;
using report::CatalogueAnswer;
using report::CatalogueFile;
using report::CatalogueMeasures;
using report::CatalogueRow;

template <class Number>
Json or_null(const std::optional<Number>& number) {
  return number ? Json(*number) : Json();
}

template <class Number>
std::optional<Number> or_nothing(const Json& json) {
  return json.is_null() ? std::nullopt : std::optional(json.get<Number>());
}

Json json_of(const CatalogueMeasures& m) {
  return {{"displacement", m.displacement},
          {"least_stress", m.least_stress},
          {"greatest_stress", m.greatest_stress},
          {"contacts", m.contacts},
          {"is_static", m.is_static},
          {"equilibrium_share", or_null(m.equilibrium_share)},
          {"displaced_element", m.displaced_element}};
}

std::optional<CatalogueMeasures> measures_of(const Json& json) {
  if (json.is_null()) return std::nullopt;
  return CatalogueMeasures{json.at("displacement"),
                           json.at("least_stress"),
                           json.at("greatest_stress"),
                           json.at("contacts"),
                           json.at("is_static"),
                           or_nothing<double>(json.at("equilibrium_share")),
                           json.value("displaced_element", 0)};
}

Json json_of(const CatalogueAnswer& a) {
  return {{"profile", a.profile}, {"end", a.end},
          {"steps", a.steps},     {"time", a.time},
          {"of_what", a.of_what}, {"dx", a.dx},
          {"dy", a.dy},           {"measures", a.measures ? json_of(*a.measures) : Json()},
          {"doubt", a.doubt},     {"failure", a.failure},
          {"reason", a.reason}};
}

CatalogueAnswer answer_of(const Json& json) {
  return {json.at("profile"),      json.at("end"),
          json.at("steps"),        json.at("time"),
          json.at("of_what"),      json.at("dx"),
          json.at("dy"),           measures_of(json.at("measures")),
          json.value("doubt", ""), json.value("failure", ""),
          json.value("reason", "")};
}

std::string cell(const std::string& text) {
  return csv_cell(text);
}

std::string cell(const std::optional<int>& number) {
  return number ? fmt::format("{}", *number) : std::string{};
}

/// Returns the texts of all items, joined by " | ".
template <class List, class Text>
std::string joined_cell(const List& list, Text text) {
  std::string all;
  for (const auto& item : list) all += (all.empty() ? "" : " | ") + text(item);
  return cell(all);
}

/// Returns `text` of the measures of each answer, "none" for one without; empty if no answer has measures.
template <class Text>
std::string measure_cell(const CatalogueRow& row, Text text) {
  if (std::ranges::none_of(row.answers, [](const CatalogueAnswer& a) { return a.measures.has_value(); })) return {};
  return joined_cell(row.answers, [&](const CatalogueAnswer& a) { return a.measures ? text(*a.measures) : "none"; });
}

std::string share_of(const CatalogueMeasures& measures) {
  if (!measures.is_static) return "dynamic";
  return measures.equilibrium_share ? fmt::format("{:.4g}", *measures.equilibrium_share) : "none known";
}

std::string text_of_number(double number) {
  return fmt::format("{:.6g}", number);
}

}  // namespace

Json json_of(const CatalogueRow& row) {
  Json files = Json::array();
  for (const CatalogueFile& f : row.files)
    files.push_back({{"path", f.path}, {"format", f.format}, {"sha256", f.sha256}});
  Json answers = Json::array();
  for (const CatalogueAnswer& answer : row.answers) answers.push_back(json_of(answer));
  return {{"job", row.name},
          {"files", files},
          {"paired_by", row.paired_by},
          {"blocks", or_null(row.blocks)},
          {"elements", or_null(row.elements)},
          {"steps", or_null(row.steps)},
          {"scene", row.scene},
          {"verdict", row.verdict.word},
          {"why", row.verdict.why},
          {"outcome", row.outcome},
          {"warnings", row.warnings},
          {"message", row.message},
          {"answers", answers},
          {"difference", or_null(row.difference)},
          {"expected", row.expected},
          {"outputs", row.outputs},
          {"thumbnail", row.thumbnail}};
}

CatalogueRow row_of(const Json& json) {
  CatalogueRow row;
  row.name = json.at("job");
  for (const Json& f : json.at("files")) row.files.push_back({f.at("path"), f.at("format"), f.at("sha256")});
  row.paired_by = json.at("paired_by");
  row.blocks = or_nothing<int>(json.at("blocks"));
  row.elements = or_nothing<int>(json.at("elements"));
  row.steps = or_nothing<int>(json.at("steps"));
  row.scene = json.at("scene");
  row.verdict = {json.value("verdict", ""), json.value("why", "")};
  row.outcome = json.at("outcome");
  row.warnings = json.at("warnings");
  row.message = json.at("message");
  for (const Json& answer : json.at("answers")) row.answers.push_back(answer_of(answer));
  row.difference = or_nothing<double>(json.at("difference"));
  row.expected = json.at("expected");
  row.outputs = json.at("outputs").get<std::vector<std::string>>();
  row.thumbnail = json.at("thumbnail");
  return row;
}

std::string catalogue_json(const std::vector<CatalogueRow>& rows) {
  Json all = Json::array();
  for (const CatalogueRow& row : rows) {
    Json json = json_of(row);
    json.erase("thumbnail");
    all.push_back(std::move(json));
  }
  return Json{{"jobs", all}}.dump(1) + "\n";
}

std::string catalogue_csv(const std::vector<CatalogueRow>& rows) {
  std::string text =
      "job,files,dialect,sha256,paired_by,blocks,elements,steps,scene,outcome,warnings,message,profiles,ends,"
      "greatest_displacement,least_stress,greatest_stress,equilibrium_share,answers,difference,expected,outputs,"
      "verdict,why\n";
  for (const CatalogueRow& row : rows)
    text += fmt::format(
        "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", cell(row.name),
        joined_cell(row.files, [](const CatalogueFile& f) { return f.path; }), cell(row.formats()),
        joined_cell(row.files, [](const CatalogueFile& f) { return f.sha256; }), cell(row.paired_by), cell(row.blocks),
        cell(row.elements), cell(row.steps), cell(row.scene), cell(row.outcome), row.warnings, cell(row.message),
        joined_cell(row.answers, [](const CatalogueAnswer& a) { return a.profile; }),
        joined_cell(row.answers, [](const CatalogueAnswer& a) { return a.end; }),
        measure_cell(row, [](const CatalogueMeasures& m) { return text_of_number(m.displacement); }),
        measure_cell(row, [](const CatalogueMeasures& m) { return text_of_number(m.least_stress); }),
        measure_cell(row, [](const CatalogueMeasures& m) { return text_of_number(m.greatest_stress); }),
        measure_cell(row, share_of),
        joined_cell(row.answers, [](const CatalogueAnswer& a) { return a.profile + ": " + report::text_of(a); }),
        row.difference ? fmt::format("{}", *row.difference) : "", cell(row.expected),
        joined_cell(row.outputs, [](const std::string& output) { return output; }), cell(row.verdict.word),
        cell(row.verdict.why));
  return text;
}

}  // namespace keyblock::study
