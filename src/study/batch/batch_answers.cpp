// Reads run.json, the last row of history.csv, and the output of `compare`.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/batch/batch_answers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
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

/// Returns the numbers of the points or blocks in the table, which has a column dxi for each.
std::vector<int> followed(const formats::CsvTable& table) {
  std::vector<int> numbers;
  for (const std::string& heading : table.header)
    if (heading.starts_with("dx")) numbers.push_back(std::atoi(heading.c_str() + 2));
  return numbers;
}

/// Takes the last point. If the table leaves out some of the blocks, the block that moves most is taken.
void add_displacement(CatalogueAnswer& answer, const std::filesystem::path& file, const Json& counts) {
  const formats::CsvTable table = formats::read_csv(formats::load(file.string()));
  const std::vector<int> numbers = followed(table);
  if (numbers.empty() || table.rows.empty()) return;
  const bool has_measured_points = counts.at("measured_points") > 0;
  const int most = answer.measures ? answer.measures->displaced_element : 0;
  const bool follows_some = !has_measured_points && counts.value("blocks", 0) > std::ssize(numbers);
  const int number = follows_some && std::ranges::count(numbers, most) > 0 ? most : numbers.back();
  const auto last = [&](std::string_view name) {
    const auto found =
        std::ranges::find_if(table.header, [heading = fmt::format("{}{}", name, number)](const std::string& h) {
          return h == heading || h.starts_with(heading + " ");
        });
    if (found == table.header.end()) throw InputError({table.name, 1, 1}, "expected displacements, found none");
    return formats::csv_real(table, table.rows.back(), static_cast<std::size_t>(found - table.header.begin()));
  };
  answer.dx = last("dx");
  answer.dy = last("dy");
  answer.of_what = fmt::format("{} {}", has_measured_points ? "measured point" : "centroid of block", number);
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
    answer.reason = outcome.value("reason", "");
    if (!answer.reason.empty()) answer.end += ": " + answer.reason;
    answer.failure = outcome.value("failure", "");
    if (const Json doubts = outcome.value("doubts", Json::array()); !doubts.empty()) answer.doubt = doubts.front();
    answer.steps = outcome.at("steps");
    answer.time = outcome.at("time");
    add_measures(answer, record);
    add_displacement(answer, folder / "history.csv", record.at("counts"));
  } catch (const Json::exception& error) {
    answer.end = fmt::format("run.json cannot be read: {}", error.what());
  } catch (const InputError&) {
    answer.has_result = false;  // the run ended before it wrote its results
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
