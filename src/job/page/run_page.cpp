// Gathers frames, tables and the record of a run; see run_page.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/page/run_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "base/bytes/file_bytes.hpp"
#include "base/bytes/sound_json.hpp"
#include "job/folder/output_files.hpp"
#include "job/page/result_frames.hpp"
#include "job/page/result_tables.hpp"
#include "job/record/run_measures.hpp"
#include "job/run_heading.hpp"
#include "job/verdict/run_verdict.hpp"
#include "report/page/page_writer.hpp"

namespace keyblock {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kPrecision =
    "Displacements and components of stress are rounded to 0.003 % of their value, contact forces to 0.01 %, other "
    "fields to 0.05 %, velocities to 0.4 %. Shear stress and the difference of principal stresses are as "
    "precise as the largest component. Curves have nine digits.";

/// Record of a run; null for a killed one. `heading_of` refuses other files before.
Json record_in(const fs::path& folder) {
  const fs::path file = folder / kRecord;
  return fs::is_regular_file(file) ? sound_json(file_bytes(file.string())) : Json();
}

Json verdict_json(const RunVerdict& verdict) {
  return {{"tone", verdict.tone}, {"words", verdict.words}, {"reason", verdict.reason}};
}

/// First and last step of each stage.
struct StageSteps {
  std::string name;
  int first = 0;
  int last = 0;
};

std::vector<StageSteps> stages_of(const Json& record) {
  std::vector<StageSteps> stages;
  if (!record.is_object() || !record.contains("stages") || !record["stages"].is_array()) return stages;
  for (const Json& stage : record["stages"]) {
    const Json steps = stage.value("steps", Json());
    if (!steps.is_array() || steps.size() != 2 || !steps[0].is_number() || !steps[1].is_number()) continue;
    stages.push_back({stage.value("name", ""), steps[0], steps[1]});
  }
  return stages;
}

/// The state before the first step belongs to the first stage.
std::string stage_at(const std::vector<StageSteps>& stages, int step) {
  for (const StageSteps& stage : stages)
    if (step <= stage.last) return stage.name;
  return {};
}

/// Names under `key` of the record's `names`, or numbers from 1 up to the count.
Json names_of(const Json& record, const char* key, std::size_t count) {
  Json names = Json::array();
  const Json known = record.is_object() ? record.value("names", Json()) : Json();
  if (known.is_object()) names = known.value(key, Json::array());
  while (names.size() < count) names.push_back("");
  for (std::size_t i = 0; i < names.size(); ++i)
    if (!names[i].is_string() || names[i].empty() || names[i] == "") names[i] = fmt::format("{}", i + 1);
  return names;
}

/// Titles of the extremes by their names.
Json titles_of_extremes(const Json& record) {
  Json titles = Json::object();
  const Json extremes = record.is_object() ? record.value("extremes", Json()) : Json();
  if (extremes.is_object())
    for (const auto& [name, value] : extremes.items()) titles[name] = title_in_record("extremes." + name + ".value");
  return titles;
}

/// Supports and loads before the first step, from the origin of the page.
Json supports_json(const Json& record, Point origin) {
  Json still = Json::array();
  const Json known = record.is_object() ? record.value("supports", Json()) : Json();
  for (const Json& support : known)
    if (support.is_object() && support.value("x", Json()).is_number() && support.value("y", Json()).is_number()) {
      const double x = support["x"], y = support["y"];
      still.push_back({{"kind", support.value("kind", Json()) == "loading_point" ? "load" : "fixed_point"},
                       {"at", {x - origin.x, y - origin.y}}});
      if (support.value("block", Json()).is_number_integer()) still.back()["block"] = support["block"];
    }
  return still;
}

/// Numbers of materials and joint materials that frames refer to.
struct Counts {
  std::size_t materials = 0;
  std::size_t joints = 0;

  void add(const report::PageFrame& frame) {
    for (const std::uint32_t material : frame.shape.material)
      materials = std::max<std::size_t>(materials, material + 1);
    for (const report::PageRows& rows : frame.parts)
      for (const report::PageColumn& column : rows.columns)
        if (rows.name == "contacts" && column.name == "joint")
          for (const double joint : column.numbers) joints = std::max(joints, static_cast<std::size_t>(joint) + 1);
  }
};

/// Tables in time of the points and tips of each frame.
struct StepTables {
  RowsByStep points, tips;
  std::map<int, double> factors;

  void add_to(report::PageFrame& frame) const {
    for (const RowsByStep* rows : {&points, &tips})
      if (const auto found = rows->find(frame.step); found != rows->end()) frame.parts.push_back(found->second);
    if (const auto factor = factors.find(frame.step); factor != factors.end()) frame.load_factor = factor->second;
  }
};

}  // namespace

std::string run_page(const fs::path& folder) {
  const std::vector<ResultFrame> frames = result_frames(folder);
  RunHeading heading = heading_of(folder);
  const Json record = record_in(folder);
  const std::vector<StageSteps> stages = stages_of(record);
  report::PageWriter page;
  Counts counts;
  StepTables tables;
  for (const ResultFrame& from : frames) {
    ReadFrame read = read_result_frame(folder, from);
    if (&from == &frames.front()) {
      if (heading.units == Units{}) heading.units = read.units;
      const bool has_units = heading.units != Units{};
      tables = {points_by_step(folder, has_units), tips_by_step(folder, has_units), load_factors(folder)};
    }
    if (!stages.empty()) read.frame.stage = stage_at(stages, from.step);
    tables.add_to(read.frame);
    counts.add(read.frame);
    page.add(std::move(read.frame));
  }
  Json head{{"format", "keyblock-page"},
            {"version", 1},
            {"program", fmt::format("keyblock {}", KEYBLOCK_VERSION)},
            {"title", heading.title},
            {"precision", kPrecision},
            {"units", heading.units == Units{} ? Json() : units_json(heading.units)},
            {"unit_by_letters", units_by_letters(heading.units)},
            {"titles", titles_of_extremes(record)},
            {"materials", names_of(record, "materials", counts.materials)},
            {"joints", names_of(record, "joints", counts.joints)},
            {"tables", result_tables(folder, heading.units != Units{})},
            {"still", supports_json(record, page.origin())},
            {"verdict", verdict_json(verdict_of(record))},
            {"run", record}};
  return std::move(page).finish(std::move(head));
}

}  // namespace keyblock
