// Puts entries of the record into tables and sentences.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/handout/run_sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "app/handout/sentences.hpp"
#include "base/words/diagnostics.hpp"
#include "job/record/run_measures.hpp"
#include "problem/units/readable.hpp"

namespace keyblock {
namespace {

using Json = nlohmann::ordered_json;
using report::DocumentSection;

using Rows = std::vector<std::vector<std::string>>;

void put(Rows& rows, const std::string& name, const std::string& value) {
  if (!value.empty()) rows.push_back({name, value});
}

// Replaces the underscores of a key by spaces.
std::string spaced(std::string key) {
  std::ranges::replace(key, '_', ' ');
  return key;
}

constexpr std::string_view kQuirk = "quirk.";

// Returns the names of the rules of Shi's programs that are on.
std::string quirks_in(const Json& settings) {
  std::string names;
  if (!settings.is_object()) return names;
  for (const auto& [name, value] : settings.items())
    if (name.starts_with(kQuirk) && value == "on") names += (names.empty() ? "" : ", ") + name.substr(kQuirk.size());
  return names;
}

std::string units_in_words(const Units& units) {
  if (units == Units{}) return "none declared: numbers are in the units of the case file";
  return fmt::format("{}, {}, {}; force {}, stress {}", units.length, units.mass, units.time,
                     unit_of(measures::kForce, units), unit_of(measures::kStress, units));
}

}  // namespace

DocumentSection result_section(const RunRecordFile& record) {
  DocumentSection section{"Results"};
  for (const Json& line : record.list("outcome.motion.sentences"))
    section.paragraphs.push_back(sentence(plain_text(line)));
  Rows rows;
  const auto with_block = [&](const std::string& path, const Measure& measure) {
    const std::string value = record.quantity(path + ".value", measure);
    const char* noun = record.at("counts.elements").is_number() ? "element" : "block";
    const std::string element = plain_text(record.at(path + ".element"));
    put(rows, title_in_record(path + ".value"),
        value.empty() ? value : fmt::format("{} ({} {})", value, noun, element));
  };
  with_block("extremes.greatest_displacement", measures::kLength);
  with_block("extremes.least_principal_stress", measures::kStress);
  with_block("extremes.greatest_principal_stress", measures::kStress);
  const auto add = [&](const char* path, const std::string& value) { put(rows, title_in_record(path), value); };
  add("outcome.motion.fastest.speed", record.quantity("outcome.motion.fastest.speed", measures::kVelocity));
  add("counts.greatest_penetration", record.quantity("counts.greatest_penetration", measures::kLength));
  add("counts.greatest_residual", plain_text(record.at("counts.greatest_residual")));
  add("ledger.closure.energy", plain_text(record.at("ledger.closure.energy")));
  section.tables.push_back({{"quantity", "value"}, rows});
  return section;
}

DocumentSection model_section(const RunRecordFile& record) {
  Rows rows;
  const bool is_static = record.at("is_static") == true;
  put(rows, "kind", is_static ? "statics: equilibrium under the loads" : "dynamics: motion in time");
  put(rows, "profile", fmt::format("{}, because {}", record.text("profile"), record.text("profile_because")));
  for (const char* name :
       {"blocks", "elements", "covers", "unknowns", "fixed_points", "loading_points", "measured_points"})
    if (const Json& count = record.at(fmt::format("counts.{}", name)); count.is_number() && count != 0)
      rows.push_back({spaced(name), plain_text(count)});
  put(rows, "units", units_in_words(record.units()));
  put(rows, "steps", plain_text(record.at("outcome.steps")));
  put(rows, "time reached", record.quantity("outcome.time", measures::kTime));
  put(rows, "time of computing",
      record.at("seconds.run").is_number() ? fmt::format("{:.3g} s", record.at("seconds.run").get<double>())
                                           : std::string());
  return {"Model", {}, {}, {{{"", ""}, rows}}};
}

DocumentSection assumption_section(const RunRecordFile& record) {
  DocumentSection section{"Assumptions"};
  const std::string plane = record.text("settings.plane");
  section.paragraphs.push_back(
      fmt::format("Two-dimensional, plane {}; forces and energies are those of a slice of unit thickness.",
                  plane.empty() ? "strain" : plane));
  if (const std::string basis = record.text("requirements.basis"); !basis.empty())
    section.paragraphs.push_back("Deformation: " + sentence(basis));
  if (const std::string made = record.text("start.made"); !made.empty())
    section.paragraphs.push_back("Initial state: " + sentence(made));
  Rows rows;
  for (const Json& term : record.list("requirements.terms"))
    put(rows, spaced(plain_text(member(term, "term"))), plain_text(member(term, "reason")));
  if (!rows.empty()) section.tables.push_back({{"effect that is computed", "why"}, rows});
  return section;
}

DocumentSection stage_section(const RunRecordFile& record) {
  Rows rows;
  for (const Json& stage : record.list("stages")) {
    const Json& steps = member(stage, "steps");
    const Json& end = member(stage, "end_time");
    if (!steps.is_array() || steps.size() != 2) continue;
    rows.push_back({plain_text(member(stage, "name")),
                    fmt::format("{} to {}", plain_text(steps[0]), plain_text(steps[1])),
                    end.is_number() ? readable(end.get<double>(), measures::kTime, record.units()) : std::string(),
                    plain_text(member(stage, "balanced"))});
  }
  return {"Stages", {}, {}, {{{"stage", "steps", "time at its end", "in equilibrium"}, rows}}};
}

DocumentSection energy_section(const RunRecordFile& record) {
  Rows rows;
  const Json& end = record.at("ledger.end");
  if (end.is_object())
    for (const auto& [name, value] : end.items()) {
      const std::string unit = record.unit_of("ledger.end." + name);
      if (value.is_number() && value != 0 && name.find("impulse") == std::string::npos)
        rows.push_back({spaced(name), fmt::format("{:.4g}", value.get<double>()), unit});
    }
  return {"Energies and momentum at the end", {}, {}, {{{"quantity", "value", "unit"}, rows}}};
}

DocumentSection setting_section(const RunRecordFile& record) {
  Rows rows;
  const Json& all = record.at("settings");
  if (all.is_object())
    for (const auto& [name, value] : all.items())
      if (const std::string text = plain_text(value); !text.empty() && !name.starts_with(kQuirk))
        rows.push_back({name, text, record.unit_of("settings." + name)});
  if (record.text("profile") == "legacy") put(rows, "rules of Shi's programs", quirks_in(all));
  for (std::vector<std::string>& row : rows) row.resize(3);
  return {"Settings", {}, {}, {{{"setting", "value", "unit"}, rows}}};
}

namespace {

/// Returns the sentence of a line "slope.json:3:5: note: sentence [code]"; another line as it is.
std::string sentence_in(std::string line, const std::string& code) {
  const std::string end = fmt::format(" [{}]", code);
  if (line.ends_with(end)) line.resize(line.size() - end.size());
  for (const char* word : {": error: ", ": warning: ", ": note: "})
    if (const std::size_t at = line.find(word); at != std::string::npos)
      return line.substr(at + std::string_view(word).size());
  return line;
}

}  // namespace

DocumentSection warning_section(const RunRecordFile& record) {
  DocumentSection section{"Warnings and notes"};
  Rows rows;
  for (const Json& warning : record.list("warnings")) {
    const std::string code = plain_text(member(warning, "name"));
    const Diagnostic* known = find_diagnostic(code);
    const DiagnosticLevel level = level_of(code);
    if (level == DiagnosticLevel::silent) continue;
    rows.push_back({std::string(word_of(level)), sentence_in(plain_text(member(warning, "first")), code),
                    known ? std::string(known->remedy) : ""});
  }
  if (rows.empty())
    section.paragraphs.push_back("None.");
  else
    section.tables.push_back({{"level", "what was found", "what to do"}, rows});
  return section;
}

}  // namespace keyblock
