// Draws values with units of their own ("50 kN") as numbers if all have the same unit.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/sweep_results.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>
#include <string_view>

#include "app/batch/shard.hpp"
#include "base/bytes/sha256.hpp"
#include "base/counted.hpp"
#include "base/error.hpp"
#include "formats/registry.hpp"
#include "formats/text/csv.hpp"
#include "job/files.hpp"
#include "report/values_picture.hpp"

namespace keyblock {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using study::SweepResult;
using study::SweepTable;

constexpr std::array<const char*, 5> kFiles{"table.csv", "columns.csv", "times.csv", "sweep.svg", "sweep.json"};

report::ValuesColumn drawn(const SweepColumn& column, const std::vector<Json>& values) {
  report::ValuesColumn found{column.label(), {}, {}};
  std::set<std::string> units;
  for (const Json& value : values) {
    const SweptAmount amount = amount_of(value);
    if (std::isfinite(amount.number)) units.insert(amount.unit);
    found.numbers.push_back(amount.number);
    found.words.push_back(value.is_string() ? value.get<std::string>() : value.dump());
  }
  if (units.size() > 1) found.numbers.assign(found.numbers.size(), std::nan(""));
  return found;
}

std::string picture_of(const std::string& title, const SweepTable& table, const std::vector<SweepColumn>& columns) {
  report::ValuesPicture picture{title, {}, {}, {}};
  for (const SweepColumn& column : columns) {
    const bool is_key = table.rows.front().contains(column.name);
    if (!is_key && std::ranges::find(table.outputs, column.name) == table.outputs.end()) continue;
    std::vector<Json> values;
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
      const Json& from = is_key ? table.rows[i] : table.results[i].out;
      values.push_back(from.contains(column.name) ? from.at(column.name) : Json());
    }
    (is_key ? picture.keys : picture.outputs).push_back(drawn(column, values));
  }
  for (const SweepResult& result : table.results) picture.verdicts.push_back(result.verdict);
  return report::values_picture(picture);
}

}  // namespace

void write_sweep(const SweepOrigin& origin, const SweepTable& table, const std::vector<SweepColumn>& columns) {
  Json record = origin.json;
  const auto write = [&](const char* name, const std::string& text) {
    write_file(origin.folder / name, text);
    record["output_sha256"][name] = sha256(text);
  };
  write("table.csv", study::table_csv(table));
  write("columns.csv", columns_csv(columns));
  write("times.csv", study::times_csv(table));
  if (const std::string picture = picture_of(origin.title, table, columns); !picture.empty())
    write("sweep.svg", picture);
  write_file(origin.folder / "sweep.json", record.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

std::string sweep_json(const SweepTable& table, const std::vector<SweepColumn>& columns) {
  Json units = Json::object();
  for (const SweepColumn& column : columns)
    if (!column.unit.empty()) units[column.name] = column.unit;
  return study::table_json(table, units);
}

ExitCode print_sweep(const ValueSweepOptions& options, const SweepTable& table,
                     const std::vector<SweepColumn>& columns) {
  std::fputs((options.as_json ? sweep_json(table, columns) : study::table_csv(table)).c_str(), stdout);
  std::map<std::string, std::size_t> verdicts;
  for (const SweepResult& result : table.results) ++verdicts[result.verdict];
  std::string words;
  for (const auto& [verdict, count] : verdicts) words += fmt::format(", {} {}", count, verdict);
  spdlog::info("{}{}; table in {}/table.csv", counted(table.rows.size(), "run"), words, options.folder);
  const bool all_finished = verdicts.size() == 1 && verdicts.contains("finished");
  return all_finished ? ExitCode::ok : ExitCode::check_failed;
}

void require_no_larger_table(const fs::path& folder, const std::vector<std::string>& jobs) {
  const fs::path file = folder / "table.csv";
  if (!fs::exists(file)) return;
  const formats::CsvTable table = formats::read_csv(formats::load(file.string()));
  const std::size_t job = formats::csv_column(table, "job");
  const std::set<std::string> own(jobs.begin(), jobs.end());
  const auto lost =
      std::ranges::count_if(table.rows, [&](const formats::CsvRow& row) { return !own.contains(row.cells[job]); });
  if (lost > 0)
    throw UsageError(fmt::format("{} has {} that this sweep lacks; give another folder, or --force to replace it",
                                 file.string(), counted(static_cast<std::size_t>(lost), "run")));
}

bool has_files_of_sweep(const fs::path& folder) {
  return std::ranges::any_of(kFiles, [&](const char* name) { return fs::exists(folder / name); });
}

void remove_sweep(const fs::path& folder) {
  const std::vector<fs::path> journals = journals_in(folder);
  for (const fs::path& journal : journals)
    if (study::read_sweep_journal(formats::load(journal.string()).text).task.empty())
      throw UsageError(fmt::format("{} is no journal of a sweep; give another folder", journal.string()));
  if (journals.empty()) return;
  std::error_code ignored;
  std::vector<fs::path> jobs;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder / "jobs", ignored))
    if (study::is_job_name(entry.path().filename().string())) jobs.push_back(entry.path());
  for (const fs::path& job : jobs) fs::remove_all(job, ignored);
  fs::remove(folder / "jobs", ignored);  // stays if it holds something else
  for (const fs::path& journal : journals) fs::remove(journal, ignored);
  for (const char* name : kFiles) fs::remove(folder / name, ignored);
}

}  // namespace keyblock
