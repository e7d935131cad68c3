// Reads run.json, the last row of history.csv, and what `compare` printed.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/batch/batch_answers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "formats/registry.hpp"
#include "formats/text/csv.hpp"

namespace keyblock::study {
namespace {

using Json = nlohmann::ordered_json;
using report::CatalogueAnswer;

Json read_json(const std::filesystem::path& file) {
  return Json::parse(formats::load(file.string()).text);
}

/// How many points the table follows: it has a column xi for each.
std::size_t point_count(const formats::CsvTable& table) {
  const auto is_abscissa = [](const std::string& heading) { return heading.starts_with("x"); };
  return static_cast<std::size_t>(std::ranges::count_if(table.header, is_abscissa));
}

void add_displacement(CatalogueAnswer& answer, const std::filesystem::path& file, bool has_measured_points) {
  const formats::CsvTable table = formats::read_csv(formats::load(file.string()));
  const std::size_t points = point_count(table);
  if (points == 0 || table.rows.empty()) return;
  const auto last = [&](std::string_view name) {
    const auto found =
        std::ranges::find_if(table.header, [heading = fmt::format("{}{}", name, points)](const std::string& h) {
          return h == heading || h.starts_with(heading + " ");
        });
    if (found == table.header.end()) throw InputError({table.name, 1, 0}, "expected displacements, found none");
    return formats::csv_real(table, table.rows.back(), static_cast<std::size_t>(found - table.header.begin()));
  };
  answer.dx = last("dx");
  answer.dy = last("dy");
  answer.of_what = fmt::format("{} {}", has_measured_points ? "measured point" : "centroid of block", points);
}

void add_measures(CatalogueAnswer& answer, const Json& record) {
  if (!record.contains("extremes") || answer.steps == 0) return;
  const Json& extremes = record.at("extremes");
  report::CatalogueMeasures measures{
      extremes.at("greatest_displacement").at("value"),          extremes.at("least_principal_stress").at("value"),
      extremes.at("greatest_principal_stress").at("value"),      record.at("counts").at("most_contacts"),
      record.value("is_static", record.contains("equilibrium")), std::nullopt,
      extremes.at("greatest_displacement").value("element", 0)};
  if (record.contains("equilibrium") && !record.at("equilibrium").at("share").is_null())
    measures.equilibrium_share = record.at("equilibrium").at("share").get<double>();
  answer.measures = measures;
}

}  // namespace

CatalogueAnswer answer_in(const std::filesystem::path& folder, const std::string& profile) {
  CatalogueAnswer answer{profile, "no result", 0, 0, {}, 0, 0, std::nullopt};
  try {
    const Json record = read_json(folder / "run.json");
    const Json& outcome = record.at("outcome");
    answer.end = outcome.at("end");
    if (outcome.contains("reason")) answer.end += ": " + outcome.at("reason").get<std::string>();
    if (const Json doubts = outcome.value("doubts", Json::array()); !doubts.empty()) answer.doubt = doubts.front();
    answer.steps = outcome.at("steps");
    answer.time = outcome.at("time");
    add_measures(answer, record);
    add_displacement(answer, folder / "history.csv", record.at("counts").at("measured_points") > 0);
  } catch (const Json::exception& error) {
    answer.end = fmt::format("run.json cannot be read: {}", error.what());
  } catch (const InputError&) {
    return answer;  // the run ended before it wrote its results
  }
  return answer;
}

std::string verdict_of(const std::string& comparison) {
  const Json json = Json::parse(comparison, nullptr, false);
  if (!json.is_object() || !json.contains("cases") || json["cases"].empty()) return "not compared";
  std::string text;
  for (const Json& run : json["cases"].front().value("runs", Json::array())) {
    if (!run.value("variant", "").empty()) continue;
    const bool is_run = run.value("not_run", "").empty();
    text += fmt::format("{}{}: {}", text.empty() ? "" : ", ", run.value("profile", ""),
                        !is_run                     ? "not run"
                        : run.value("holds", false) ? "hold"
                                                    : "missed");
  }
  return text;
}

std::optional<double> difference_of(const std::vector<CatalogueAnswer>& answers) {
  const auto is_whole = [](const CatalogueAnswer& a) { return a.end == "finished" && !a.of_what.empty(); };
  if (answers.size() < 2 || !is_whole(answers.front()) || !is_whole(answers.back())) return std::nullopt;
  return std::hypot(answers.back().dx - answers.front().dx, answers.back().dy - answers.front().dy);
}

}  // namespace keyblock::study
