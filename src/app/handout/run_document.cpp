// Puts the sections of a report together, in the order in which a client asks: does it stand, what moved, on which
// assumptions, with which numbers.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/handout/run_document.hpp"

#include <fmt/format.h>

#include "app/handout/material_tables.hpp"
#include "app/handout/recorded_curves.hpp"
#include "app/handout/run_sections.hpp"
#include "app/handout/sentences.hpp"
#include "app/handout/table_sections.hpp"
#include "job/folder/output_files.hpp"
#include "job/run_heading.hpp"
#include "job/verdict/run_verdict.hpp"

namespace keyblock {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using report::DocumentPicture;
using report::Verdict;

constexpr std::size_t kMostCurves = 8;

Verdict verdict_by(std::string_view tone) {
  return tone == "bad" ? Verdict::bad : tone == "warn" ? Verdict::doubtful : Verdict::good;
}

std::string sentences_on(const RunVerdict& verdict, const RunRecordFile& record) {
  switch (verdict.state) {
    case RunState::failed:
      return "The run failed: " + sentence(verdict.reason);
    case RunState::stopped:
      return sentence("The run was stopped before its end" + (verdict.reason.empty() ? "" : ": " + verdict.reason));
    case RunState::unreliable: {
      std::string words = "The run came to its end, but its results cannot be trusted.";
      for (const Json& doubt : record.list("outcome.doubts")) words += " " + sentence(plain_text(doubt));
      return words;
    }
    default:
      break;
  }
  const Json& motion = record.list("outcome.motion.sentences");
  return "The run came to its end, and its checks found nothing against it." +
         (motion.empty() ? "" : " " + sentence(plain_text(motion[0])));
}

// Draws the displacements of the measured points.
std::optional<DocumentPicture> displacement_curves(const fs::path& folder, const RunRecordFile& record) {
  CurveRequest request;
  for (const std::string& name : recorded_names(folder))
    if ((name.starts_with("dx") || name.starts_with("dy")) && request.names.size() < kMostCurves)
      request.names.push_back(name);
  if (request.names.empty() || record.at("outcome.steps") == 0) return std::nullopt;
  return DocumentPicture{recorded_picture(folder, request, "", record.units()),
                         record.at("counts.measured_points") == 0 ? "Displacements over time"
                                                                  : "Displacements of the measured points over time"};
}

}  // namespace

Judged judged(const RunRecordFile& record, const FrameState& frames) {
  const RunVerdict verdict = verdict_of(record.json());
  if (frames.fault.empty())
    return {verdict_by(verdict.tone), std::string(verdict.words), sentences_on(verdict, record)};
  return {Verdict::bad, "results damaged",
          "The results in this folder are damaged: " + sentence(frames.fault) +
              " Run the case again, or restore the folder, before you rely on this report."};
}

std::string program_of(const RunRecordFile& record) {
  return fmt::format("{} {}", record.text("program") == "keyblock" ? "Keyblock" : record.text("program"),
                     record.text("version"));
}

std::vector<DocumentPicture> run_pictures(const fs::path& folder, std::size_t most) {
  return pictures_in(folder,
                     {{"picture.svg", "Blocks at the end of the run, with the start in outline"},
                      {"cracks.svg", "Cracks at the end of the run"},
                      {"field.svg", "Field at the end of the run; stress is positive in tension"},
                      {"energy.svg", "Energies over time"},
                      {kReactionFile, "Reactions of the supports"}},
                     most);
}

Handout run_document(const fs::path& folder, const std::string& project) {
  const RunRecordFile record(folder);
  const FrameState frames = frames_of(folder);
  const Judged judgement = judged(record, frames);
  report::Document document{heading_of(folder).title, "Report of a run", judgement.verdict, judgement.words, {}};
  document.facts = facts_of(project, program_of(record), folder / kRecord);
  std::vector<report::DocumentSection>& sections = document.sections;
  add_if_filled(sections, {"Pictures", {}, run_pictures(folder), {}});
  add_if_filled(sections, result_section(record));
  if (const auto curves = displacement_curves(folder, record)) sections.push_back({"Histories", {}, {*curves}, {}});
  add_if_filled(sections, stage_section(record));
  add_if_filled(sections, bolt_section(folder, record));
  add_if_filled(sections, contact_section(folder, record));
  add_if_filled(sections, crack_section(folder, record));
  add_if_filled(sections, model_section(record));
  add_if_filled(sections, assumption_section(record));
  add_if_filled(sections, material_section(record));
  add_if_filled(sections, warning_section(record));
  add_if_filled(sections, energy_section(record));
  add_if_filled(sections, setting_section(record));
  add_if_filled(sections, checksum_section(folder, record));
  add_anchors(sections);
  Handout handout{std::move(document), {}};
  if (!frames.fault.empty()) handout.faults.push_back(folder.string() + ": error: " + frames.fault);
  return handout;
}

}  // namespace keyblock
