// Finds each output in the record or in a table of the run.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/sweep/sweep_outputs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>
#include <utility>

#include "api/case_values.hpp"
#include "base/bytes/sound_json.hpp"
#include "formats/registry.hpp"
#include "formats/tables/run_tables.hpp"
#include "formats/text/csv.hpp"
#include "run/follow/stop_criterion.hpp"

namespace keyblock::study {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Named = std::pair<std::string_view, std::string_view>;

constexpr std::array<Named, 6> kOfRecord{{{"displacement", "/extremes/greatest_displacement/value"},
                                          {"speed", "/outcome/motion/fastest/speed"},
                                          {"state", "/outcome/motion/state"},
                                          {"steps", "/outcome/steps"},
                                          {"time", "/outcome/time"},
                                          {"blocks", "/counts/blocks"}}};
constexpr std::array<Named, 4> kFactors{
    {{"fos", ""}, {"fos_joints", "joints"}, {"fos_rock", "rock"}, {"fos_both", "both"}}};
constexpr std::array<Named, 4> kOfTip{{{"k1", "K_I"}, {"k2", "K_II"}, {"j", "J"}, {"kink_deg", "kink_deg"}}};
const std::array<std::pair<std::string_view, const formats::RunTable*>, 3> kTables{
    {{"ledger", &formats::kLedgerTable}, {"history", &formats::kHistoryTable}, {"step_table", &formats::kStepTable}}};

template <std::size_t size>
const std::string_view* found_in(const std::array<Named, size>& table, std::string_view name) {
  const auto found = std::ranges::find(table, name, &Named::first);
  return found == table.end() ? nullptr : &found->second;
}

/// Returns the number behind a prefix: 2 of "point2"; 0 for other texts.
std::size_t number_of(std::string_view text, std::string_view prefix) {
  std::size_t number = 0;
  if (!text.starts_with(prefix)) return 0;
  const auto [end, fault] = std::from_chars(text.data() + prefix.size(), text.data() + text.size(), number);
  return fault == std::errc() && end == text.data() + text.size() ? number : 0;
}

std::pair<std::string, std::string> at_dot(const std::string& name) {
  const std::size_t dot = name.rfind('.');
  if (dot == std::string::npos) return {name, ""};
  return {name.substr(0, dot), name.substr(dot + 1)};
}

[[noreturn]] void refuse(const std::string& found, const std::string& expected) {
  throw std::invalid_argument(fmt::format("--out: expected {}, found {}", expected, found));
}

[[noreturn]] void lack(const SweepOutput& output, const std::string& expected) {
  throw OutputLacking(fmt::format("expected {}, found {}", expected, output.name));
}

/// Returns the table whose last row has the outputs of this owner; null: that of the histories.
const formats::RunTable* table_of(const std::string& owner) {
  const auto found = std::ranges::find(kTables, owner, &decltype(kTables)::value_type::first);
  if (found != kTables.end()) return found->second;
  return number_of(owner, "point") > 0 ? &formats::kPointsTable : nullptr;
}

void require_column(const formats::RunTable& table, const std::string& quantity, const std::string& name) {
  if (has_column(table, quantity)) return;
  std::vector<std::string> names;
  for (const formats::Column& column : table.columns) names.emplace_back(column.name);
  refuse(name, fmt::format("a column of {}: {}", table.file, fmt::join(names, ", ")));
}

SweepOutput output_of(const std::string& name) {
  if (const std::string_view* reduced = found_in(kFactors, name))
    return {name, SweepSource::fos, std::string(*reduced)};
  const auto [owner, quantity] = at_dot(name);
  if (number_of(owner, "tip") > 0 && found_in(kOfTip, quantity) != nullptr) return {name, SweepSource::sif};
  if (name.starts_with('/') || found_in(kOfRecord, name) != nullptr) return {name};
  if (quantity.empty())
    refuse(
        name,
        "displacement, speed, state, steps, time, blocks, fos, fos_joints, fos_rock, fos_both, point1.dx, NAME.dx of "
        "a history, a column such as ledger.kinetic, tip1.k1, or a pointer into run.json");
  const formats::RunTable* table = table_of(owner);
  if (table == nullptr) return {name, SweepSource::run, {}, owner};
  require_column(*table, quantity, name);
  return {name};
}

Json number_in(const std::string& text) {
  if (text.empty()) return {};
  const Json json = sound_json(text);
  return json.is_discarded() ? Json(text) : json;
}

std::string names_in(const std::vector<std::string>& header) {
  std::string names;
  for (const std::string& heading : header) {
    names += (names.empty() ? "" : ", ") + formats::csv_heading(heading).name;
  }
  return names;
}

/// Returns the cell of the last row that `is_wanted` takes.
template <class Wanted>
SweptValue last_cell(const formats::CsvTable& table, const SweepOutput& output, const std::string& heading,
                     Wanted is_wanted) {
  const auto column =
      std::ranges::find_if(table.header, [&](const std::string& h) { return formats::csv_heading(h).name == heading; });
  if (column == table.header.end())
    lack(output, fmt::format("a column of {}: {}", fs::path(table.name).filename().string(), names_in(table.header)));
  for (auto row = table.rows.rbegin(); row != table.rows.rend(); ++row)
    if (is_wanted(*row))
      return {number_in(row->cells[static_cast<std::size_t>(column - table.header.begin())]),
              formats::csv_heading(*column).unit};
  return {};
}

SweptValue of_history(const formats::CsvTable& table, const SweepOutput& output, const std::string& owner,
                      const std::string& quantity) {
  const std::string wanted = long_quantity(quantity);
  const std::size_t name = formats::csv_column(table, "name");
  const std::size_t what = formats::csv_column(table, "quantity");
  const auto is_wanted = [&](const formats::CsvRow& row) {
    return row.cells[name] == owner && row.cells[what] == wanted;
  };
  if (const auto row = std::ranges::find_if(table.rows, is_wanted); row != table.rows.end())
    return {last_cell(table, output, "value", is_wanted).value, row->cells[formats::csv_column(table, "unit")]};
  std::vector<std::string> known;
  for (const formats::CsvRow& row : table.rows) {
    std::string one = fmt::format("{}.{}", row.cells[name], row.cells[what]);
    if (std::ranges::find(known, one) != known.end()) break;
    known.push_back(std::move(one));
  }
  lack(output, "a quantity of a history: " + names_in(known));
}

SweptValue of_table(const SweepOutput& output, const fs::path& folder) {
  const auto [owner, quantity] = at_dot(output.name);
  const formats::RunTable* of_run = table_of(owner);
  const fs::path file = folder / (of_run != nullptr ? *of_run : formats::kHistoriesTable).file;
  if (!fs::exists(file)) lack(output, fmt::format("a result of the run, which has no {}", file.filename().string()));
  const formats::CsvTable table = formats::read_csv(formats::load(file.string()));
  if (of_run == nullptr) return of_history(table, output, owner, quantity);
  if (of_run != &formats::kPointsTable)
    return last_cell(table, output, quantity, [](const formats::CsvRow&) { return true; });
  const std::size_t number = formats::csv_column(table, "point");
  const std::string wanted = fmt::format("{}", number_of(owner, "point"));
  const auto is_wanted = [&](const formats::CsvRow& row) { return row.cells[number] == wanted; };
  if (std::ranges::none_of(table.rows, is_wanted)) lack(output, "the number of a measured point");
  return last_cell(table, output, quantity, is_wanted);
}

/// Returns the unit of a value of run.json, which lists units by paths such as supports[].x.
std::string unit_of_record(const Json& record, const std::string& pointer) {
  std::string path;
  for (const std::string& step : pointer_steps(pointer))
    path += is_list_index(step) ? "[]" : path.empty() ? step : "." + step;
  const Json units = record.value("unit_of", Json::object());
  return units.contains(path) ? units.at(path).get<std::string>() : std::string();
}

}  // namespace

std::vector<SweepOutput> sweep_outputs_of(const std::string& list) {
  std::vector<SweepOutput> outputs;
  for (std::size_t begin = 0; begin <= list.size();) {
    const std::size_t end = std::min(list.find(',', begin), list.size());
    const std::string name = list.substr(begin, end - begin);
    if (name.empty()) refuse(list, "names separated by commas");
    if (std::ranges::find(outputs, name, &SweepOutput::name) != outputs.end())
      refuse(name + " twice", "each name once");
    outputs.push_back(output_of(name));
    begin = end + 1;
  }
  return outputs;
}

SweptValue value_of_run(const SweepOutput& output, const fs::path& folder) {
  const Json record = Json::parse(formats::load((folder / "run.json").string()).text);
  if (record.at("outcome").at("steps") == 0) return {};
  const std::string_view* place = found_in(kOfRecord, output.name);
  if (place == nullptr && !output.name.starts_with('/')) return of_table(output, folder);
  const std::string pointer = place != nullptr ? std::string(*place) : output.name;
  try {
    return {record.at(Json::json_pointer(pointer)), unit_of_record(record, pointer)};
  } catch (const Json::exception&) {
    lack(output, "a pointer to a value of run.json");
  }
}

Json value_of_fos(const std::string& fos_json) {
  const Json json = sound_json(fos_json);
  return json.is_object() ? json.value(Json::json_pointer("/bracket/stands"), Json()) : Json();
}

std::string last_trial_of(const std::string& fos_json) {
  const Json trials = Json::parse(fos_json).value("trials", Json::array());
  if (trials.empty()) return {};
  const Json& last = trials.back();
  const std::string why = last.value("why", "");
  return fmt::format("F = {:.6g}: {}{}", last.value("factor", 0.0), last.value("verdict", ""),
                     why.empty() ? why : ": " + why);
}

SweptValue value_of_sif(const SweepOutput& output, const std::string& sif_json) {
  const Json json = Json::parse(sif_json);
  const auto [owner, quantity] = at_dot(output.name);
  const std::size_t tip = number_of(owner, "tip");
  const Json& tips = json.at("tips");
  if (tip > tips.size()) lack(output, fmt::format("one of {} tips", tips.size()));
  return {tips.at(tip - 1).at(std::string(*found_in(kOfTip, quantity)))};
}

}  // namespace keyblock::study
