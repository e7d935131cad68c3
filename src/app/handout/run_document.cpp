// Puts the sections of a report together, in the order in which a client asks: does it stand, what moved, on which
// assumptions, with which numbers.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/handout/run_document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "app/handout/material_tables.hpp"
#include "app/handout/record_reading.hpp"
#include "app/handout/recorded_curves.hpp"
#include "base/bytes/file_bytes.hpp"
#include "base/error.hpp"
#include "base/words/diagnostics.hpp"
#include "job/folder/output_files.hpp"
#include "job/run_heading.hpp"
#include "problem/units/readable.hpp"

namespace keyblock {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using report::DocumentPicture;
using report::DocumentSection;
using report::DocumentTable;

using Rows = std::vector<std::vector<std::string>>;

constexpr std::size_t kMostCurves = 8;

void put(Rows& rows, const std::string& name, const std::string& value) {
  if (!value.empty()) rows.push_back({name, value});
}

// Begins a sentence with a capital letter and ends it with a full stop.
std::string sentence(std::string text) {
  if (text.empty()) return text;
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  if (text.back() != '.') text += '.';
  return text;
}

struct Judged {
  report::Verdict verdict = report::Verdict::good;
  std::string words;
};

Judged judged(const RunRecordFile& record) {
  const std::string end = record.text("outcome.end");
  if (end == "failed") return {report::Verdict::bad, "The run failed: " + sentence(record.text("outcome.reason"))};
  std::string doubts;
  for (const Json& doubt : record.list("outcome.doubts")) doubts += " " + sentence(plain_text(doubt));
  if (!doubts.empty())
    return {report::Verdict::bad, "The run came to its end, but its results cannot be trusted." + doubts};
  if (end != "finished") return {report::Verdict::doubtful, sentence("the run did not come to its end: " + end)};
  std::string words = "The run came to its end, and its checks found nothing against it.";
  const Json& motion = record.list("outcome.motion.sentences");
  if (!motion.empty()) words += " " + sentence(plain_text(motion[0]));
  if (record.text("outcome.motion.state") == "moving") return {report::Verdict::doubtful, words};
  return {report::Verdict::good, words};
}

std::vector<DocumentPicture> pictures_in(const fs::path& folder, bool all) {
  std::vector<DocumentPicture> pictures;
  const std::vector<std::pair<std::string, std::string>> known{
      {"picture.svg", "Blocks at the end of the run, with the start in outline"},
      {"field.svg", "Stress at the end of the run, tension positive"},
      {"energy.svg", "Energies over time"}};
  for (const auto& [name, caption] : known) {
    if (fs::is_regular_file(folder / name)) pictures.push_back({file_bytes((folder / name).string()), caption});
    if (!all && !pictures.empty()) break;
  }
  return pictures;
}

DocumentSection results(const RunRecordFile& record) {
  DocumentSection section{"Results"};
  for (const Json& line : record.list("outcome.motion.sentences"))
    section.paragraphs.push_back(sentence(plain_text(line)));
  Rows rows;
  const auto with_block = [&](const std::string& path, const Measure& measure) {
    const std::string value = record.quantity(path + ".value", measure);
    return value.empty() ? value : fmt::format("{} (block {})", value, plain_text(record.at(path + ".element")));
  };
  put(rows, "largest displacement", with_block("extremes.greatest_displacement", measures::kLength));
  put(rows, "least principal stress", with_block("extremes.least_principal_stress", measures::kStress));
  put(rows, "greatest principal stress", with_block("extremes.greatest_principal_stress", measures::kStress));
  put(rows, "largest speed at the end", record.quantity("outcome.motion.fastest.speed", measures::kVelocity));
  put(rows, "deepest overlap of blocks", record.quantity("counts.greatest_penetration", measures::kLength));
  put(rows, "largest force out of balance, over the load", plain_text(record.at("counts.greatest_residual")));
  put(rows, "error of the energy balance, over the largest energy", plain_text(record.at("ledger.closure.energy")));
  section.tables.push_back({{"quantity", "value"}, rows});
  return section;
}

DocumentSection size_of(const RunRecordFile& record) {
  Rows rows;
  const bool is_static = record.at("is_static") == true;
  put(rows, "kind", is_static ? "statics: equilibrium under the loads" : "dynamics: motion in time");
  put(rows, "profile", fmt::format("{}, because {}", record.text("profile"), record.text("profile_because")));
  for (const char* name :
       {"blocks", "elements", "covers", "unknowns", "fixed_points", "loading_points", "measured_points"})
    if (const Json& count = record.at(fmt::format("counts.{}", name)); count.is_number() && count != 0)
      rows.push_back({std::string(name).replace(std::min(std::string(name).size(), std::string(name).find('_')),
                                                std::string(name).find('_') == std::string::npos ? 0 : 1, " "),
                      plain_text(count)});
  put(rows, "steps", plain_text(record.at("outcome.steps")));
  put(rows, "time reached", record.quantity("outcome.time", measures::kTime));
  put(rows, "time of computing",
      record.at("seconds.run").is_number() ? fmt::format("{:.3g} s", record.at("seconds.run").get<double>())
                                           : std::string());
  return {"Model", {}, {}, {{{"", ""}, rows}}};
}

DocumentSection assumptions(const RunRecordFile& record) {
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
    put(rows, plain_text(member(term, "term")), plain_text(member(term, "reason")));
  if (!rows.empty()) section.tables.push_back({{"effect that is computed", "why"}, rows});
  return section;
}

DocumentSection stages(const RunRecordFile& record) {
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

DocumentSection energies(const RunRecordFile& record) {
  Rows rows;
  const Json& end = record.at("ledger.end");
  if (end.is_object())
    for (const auto& [name, value] : end.items()) {
      const std::string unit = record.unit_of("ledger.end." + name);
      if (value.is_number() && value != 0 && name.find("impulse") == std::string::npos)
        rows.push_back({name, fmt::format("{:.4g}", value.get<double>()), unit});
    }
  return {"Energies and momentum at the end", {}, {}, {{{"quantity", "value", "unit"}, rows}}};
}

DocumentSection settings(const RunRecordFile& record) {
  Rows rows;
  const Json& all = record.at("settings");
  if (all.is_object())
    for (const auto& [name, value] : all.items())
      if (const std::string text = plain_text(value); !text.empty())
        rows.push_back({name, text, record.unit_of("settings." + name)});
  return {"Settings", {}, {}, {{{"setting", "value", "unit"}, rows}}};
}

DocumentSection warnings(const RunRecordFile& record) {
  DocumentSection section{"Warnings and notes"};
  Rows rows;
  for (const Json& warning : record.list("warnings")) {
    const std::string code = plain_text(member(warning, "name"));
    const Diagnostic* known = find_diagnostic(code);
    const DiagnosticLevel level = level_of(code);
    if (level == DiagnosticLevel::silent) continue;
    rows.push_back(
        {std::string(word_of(level)), plain_text(member(warning, "first")), known ? std::string(known->remedy) : ""});
  }
  if (rows.empty())
    section.paragraphs.push_back("None.");
  else
    section.tables.push_back({{"level", "what was found", "what to do"}, rows});
  return section;
}

DocumentSection files(const RunRecordFile& record) {
  Rows rows;
  for (const Json& input : record.list("inputs"))
    rows.push_back(
        {plain_text(member(input, "file")), plain_text(member(input, "format")), plain_text(member(input, "sha256"))});
  return {"Input files", {}, {}, {{{"file", "format", "SHA-256"}, rows}}};
}

// Draws the displacements of the measured points.
std::optional<DocumentPicture> displacement_curves(const fs::path& folder, const RunRecordFile& record) {
  CurveRequest request;
  for (const std::string& name : recorded_names(folder))
    if ((name.starts_with("dx") || name.starts_with("dy")) && request.names.size() < kMostCurves)
      request.names.push_back(name);
  if (request.names.empty() || record.at("outcome.steps") == 0) return std::nullopt;
  return DocumentPicture{recorded_picture(folder, request, "", record.units()),
                         "Displacements of the measured points over time"};
}

std::string program_of(const RunRecordFile& record) {
  return fmt::format("{} {}", record.text("program") == "keyblock" ? "Keyblock" : record.text("program"),
                     record.text("version"));
}

void add_if_filled(std::vector<DocumentSection>& sections, DocumentSection section) {
  const bool has_rows =
      std::ranges::any_of(section.tables, [](const DocumentTable& table) { return !table.rows.empty(); });
  if (has_rows || !section.pictures.empty() || !section.paragraphs.empty()) sections.push_back(std::move(section));
}

std::vector<fs::path> runs_below(const fs::path& folder) {
  constexpr int kDeepest = 4;
  std::vector<fs::path> runs;
  const auto options = fs::directory_options::skip_permission_denied;
  for (auto entry = fs::recursive_directory_iterator(folder, options); entry != fs::recursive_directory_iterator();
       ++entry) {
    if (entry.depth() >= kDeepest) entry.disable_recursion_pending();
    if (entry->is_regular_file() && entry->path().filename() == kRecord) runs.push_back(entry->path().parent_path());
  }
  std::ranges::sort(runs);
  return runs;
}

}  // namespace

report::Document run_document(const fs::path& folder) {
  const RunRecordFile record(folder);
  const Judged judgement = judged(record);
  report::Document document{
      heading_of(folder).title, "Report of a run, " + program_of(record), judgement.verdict, judgement.words, {}};
  std::vector<DocumentSection>& sections = document.sections;
  add_if_filled(sections, {"Pictures", {}, pictures_in(folder, true), {}});
  add_if_filled(sections, results(record));
  if (const auto curves = displacement_curves(folder, record)) sections.push_back({"Histories", {}, {*curves}, {}});
  add_if_filled(sections, stages(record));
  add_if_filled(sections, size_of(record));
  add_if_filled(sections, assumptions(record));
  add_if_filled(sections, material_section(record));
  add_if_filled(sections, warnings(record));
  add_if_filled(sections, energies(record));
  add_if_filled(sections, files(record));
  add_if_filled(sections, settings(record));
  for (DocumentSection& section : sections) {
    section.anchor = section.heading;
    std::ranges::replace(section.anchor, ' ', '-');
  }
  return document;
}

report::Document archive_document(const fs::path& folder) {
  const std::vector<fs::path> runs = runs_below(folder);
  if (runs.empty())
    throw InputError({folder.string()},
                     fmt::format("expected the folder of a run, or one of runs, with {}, found none", kRecord));
  report::Document document{
      fs::absolute(folder / ".").lexically_normal().parent_path().filename().string(), "", {}, {}, {}};
  Rows rows;
  std::vector<DocumentSection> sections;
  std::map<report::Verdict, int> counts;
  for (const fs::path& run : runs) {
    const RunRecordFile record(run);
    const Judged judgement = judged(record);
    ++counts[judgement.verdict];
    document.subtitle = "Report of runs, " + program_of(record);
    const std::string name = fs::relative(run, folder).string();
    rows.push_back({name, record.text("profile"),
                    judgement.verdict == report::Verdict::good       ? "trusted"
                    : judgement.verdict == report::Verdict::doubtful ? "still moving, or not at its end"
                                                                     : "not trusted",
                    plain_text(record.at("outcome.steps")),
                    record.quantity("extremes.greatest_displacement.value", measures::kLength)});
    DocumentSection section{name, {judgement.words}, pictures_in(run, false), {}};
    for (const Json& line : record.list("outcome.motion.sentences"))
      section.paragraphs.push_back(sentence(plain_text(line)));
    sections.push_back(std::move(section));
  }
  const int bad = counts[report::Verdict::bad], open = counts[report::Verdict::doubtful];
  document.verdict = bad > 0 ? report::Verdict::bad : open > 0 ? report::Verdict::doubtful : report::Verdict::good;
  document.verdict_in_words =
      fmt::format("{} runs: {} trusted and at rest, {} still moving or not at their end, {} not trusted.", runs.size(),
                  counts[report::Verdict::good], open, bad);
  document.sections.push_back(
      {"Runs", {}, {}, {{{"run", "profile", "verdict", "steps", "largest displacement"}, rows}}});
  std::ranges::move(sections, std::back_inserter(document.sections));
  return document;
}

}  // namespace keyblock
