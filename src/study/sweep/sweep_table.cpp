// Writes numbers with the fewest digits that read back the same.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/sweep/sweep_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <stdexcept>

#include "base/bytes/sound_json.hpp"
#include "base/printable.hpp"

namespace keyblock::study {
namespace {

using Json = nlohmann::ordered_json;

std::string line_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

SweepResult result_of(const Json& json) {
  return {json.at("job"),
          json.at("verdict"),
          json.at("doubt"),
          json.value("warnings", ""),
          json.at("out"),
          json.at("seconds"),
          json.value("units", Json::object()),
          json.value("lacking", Json::object()),
          json.value("files", "")};
}

std::string cell_of(const Json& value) {
  if (value.is_null()) return {};
  if (value.is_string()) return csv_cell(value.get<std::string>());
  if (value.is_number_float())
    return std::isfinite(value.get<double>()) ? fmt::format("{}", value.get<double>()) : std::string();
  return csv_cell(value.dump());
}

Json value_or_null(const Json& object, const std::string& key) {
  return object.contains(key) ? object.at(key) : Json();
}

}  // namespace

void SweepJournal::add(std::string_view line) {
  const Json json = sound_json(line);
  if (!json.is_object()) return;
  try {
    if (task.empty()) {
      if (!json.contains("sweep")) return;
      task = json.at("task");
    } else {
      SweepResult result = result_of(json);
      results.insert_or_assign(result.job, std::move(result));
    }
  } catch (const Json::exception&) {
    return;
  }
  lines += line;
}

bool is_of_a_sweep(const std::filesystem::path& folder) {
  constexpr std::string_view kHead = "{\"sweep\":";
  std::ifstream stream(folder / "journal.jsonl", std::ios::binary);
  std::string head(kHead.size(), ' ');
  return stream.read(head.data(), static_cast<std::streamsize>(head.size())) && head == kHead;
}

std::string sweep_journal_head(const std::string& task) {
  return line_of({{"sweep", 1}, {"task", task}});
}

std::string sweep_journal_line(const SweepResult& result) {
  return line_of({{"job", result.job},
                  {"verdict", result.verdict},
                  {"doubt", result.doubt},
                  {"warnings", result.warnings},
                  {"out", result.out},
                  {"units", result.units},
                  {"lacking", result.lacking},
                  {"files", result.files},
                  {"seconds", result.seconds}});
}

SweepJournal read_sweep_journal(std::string_view text) {
  SweepJournal journal;
  for (std::size_t end = text.find('\n'); end != std::string_view::npos; end = text.find('\n')) {
    journal.add(text.substr(0, end + 1));
    text.remove_prefix(end + 1);
  }
  return journal;
}

void require_outputs(const SweepTable& table) {
  for (const std::string& name : table.outputs) {
    const auto has = [&](const SweepResult& result) { return !value_or_null(result.out, name).is_null(); };
    const auto lacks = [&](const SweepResult& result) { return result.lacking.contains(name); };
    const auto lacking = std::ranges::find_if(table.results, lacks);
    if (lacking != table.results.end() && std::ranges::none_of(table.results, has))
      throw std::invalid_argument(fmt::format("--out: {}, in every run", lacking->lacking.at(name).get<std::string>()));
  }
}

std::string table_csv(const SweepTable& table) {
  std::string text;
  for (const auto& [key, value] : table.rows.front().items()) text += csv_cell(key) + ",";
  text += "verdict,doubt,warnings,";
  for (const std::string& name : table.outputs) text += csv_cell(name) + ",";
  text += "job\n";
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const SweepResult& result = table.results[i];
    for (const auto& [key, value] : table.rows[i].items()) text += cell_of(value) + ",";
    text += fmt::format("{},{},{},", csv_cell(result.verdict), csv_cell(result.doubt), result.warnings);
    for (const std::string& name : table.outputs) text += cell_of(value_or_null(result.out, name)) + ",";
    text += result.job + "\n";
  }
  return text;
}

std::string times_csv(const SweepTable& table) {
  std::string text = "job,seconds\n";
  for (const SweepResult& result : table.results) text += fmt::format("{},{:.3f}\n", result.job, result.seconds);
  return text;
}

std::string table_json(const SweepTable& table, const Json& units) {
  Json rows = Json::array();
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const SweepResult& result = table.results[i];
    Json row = table.rows[i];
    row["verdict"] = result.verdict;
    row["doubt"] = result.doubt;
    row["warnings"] = result.warnings;
    for (const std::string& name : table.outputs) row[name] = value_or_null(result.out, name);
    row["job"] = result.job;
    rows.push_back(std::move(row));
  }
  Json seconds = Json::array();
  for (const SweepResult& result : table.results) seconds.push_back(result.seconds);
  return Json{{"rows", rows}, {"seconds", seconds}, {"units", units}}.dump(1, ' ', false,
                                                                           Json::error_handler_t::replace) +
         "\n";
}

}  // namespace keyblock::study
