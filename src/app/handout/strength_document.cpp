// Reads the record with a sentence for each end of the search.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/handout/strength_document.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/handout/material_tables.hpp"
#include "app/handout/sentences.hpp"
#include "app/handout/table_sections.hpp"
#include "base/words/diagnostics.hpp"
#include "base/words/plain_number.hpp"

namespace keyblock {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using report::DocumentSection;
using report::Verdict;

using Rows = std::vector<std::vector<std::string>>;

constexpr int kDigitsOfFactor = 4;

std::string factor_text(const Json& factor) {
  return factor.is_number() ? plain(factor.get<double>(), kDigitsOfFactor) : std::string();
}

std::string reduced_in_words(const Json& record) {
  const std::string what = plain_text(member(record, "reduced"));
  return what == "both" ? "joints and rock" : what;
}

std::string state_of(const std::string& verdict) {
  return verdict == "stands" ? "stable" : verdict == "falls" ? "unstable" : verdict;
}

DocumentSection result_of(const StrengthRecord& record) {
  const Json& json = record.json();
  Rows rows;
  const auto put = [&](const char* name, const std::string& value) {
    if (!value.empty()) rows.push_back({name, value});
  };
  put("factor of safety", factor_text(member(json, "factor_of_safety")));
  put("stable at", factor_text(member(member(json, "bracket"), "stands")));
  put("unstable at", factor_text(member(member(json, "bracket"), "falls")));
  put("requested width of the bracket, relative", plain_text(member(json, "to_within")));
  put("reduced strength", reduced_in_words(json));
  put("serviceability factor", factor_text(member(member(json, "serviceability"), "factor")));
  put("profile", plain_text(member(json, "profile")));
  std::string exempt;
  if (member(json, "exempt").is_array())
    for (const Json& word : member(json, "exempt")) exempt += (exempt.empty() ? "" : ", ") + plain_text(word);
  put("exempt from reduction", exempt);
  return {"Results", {}, {}, {{{"quantity", "value"}, rows}}};
}

DocumentSection trials_of(const StrengthRecord& record) {
  Rows rows;
  Json trials = record.list("trials");
  std::stable_sort(trials.begin(), trials.end(), [](const Json& a, const Json& b) {
    const Json &x = member(a, "factor"), &y = member(b, "factor");
    return x.is_number() && y.is_number() && x.get<double>() < y.get<double>();
  });
  for (const Json& trial : trials)
    rows.push_back({factor_text(member(trial, "factor")), state_of(plain_text(member(trial, "verdict"))),
                    plain_text(member(trial, "largest_displacement")), plain_text(member(trial, "why"))});
  const std::string unit = record.units().length;
  const std::string displacement =
      unit.empty() ? "largest displacement" : fmt::format("largest displacement [{}]", unit);
  return {"Trials", {}, {}, {{{"factor", "model", displacement, "reason"}, rows}}};
}

}  // namespace

DocumentSection warning_section(const StrengthRecord& record) {
  DocumentSection section{"Warnings and notes"};
  for (const Json& note : record.list("notes")) section.paragraphs.push_back(sentence(plain_text(note)));
  Rows rows;
  for (const Json& warning : record.list("warnings")) {
    const std::string code = plain_text(member(warning, "name"));
    if (level_of(code) == DiagnosticLevel::silent) continue;
    const Diagnostic* known = find_diagnostic(code);
    rows.push_back({std::string(word_of(level_of(code))), plain_text(member(warning, "sentence")),
                    known ? std::string(known->remedy) : ""});
  }
  if (!rows.empty()) section.tables.push_back({{"level", "what was found", "what to do"}, rows});
  return section;
}

StrengthRecord::StrengthRecord(const fs::path& folder)
    : ResultRecord(folder / kStrengthRecord, "bracket", "a search for the factor of safety") {}

std::string_view StrengthRecord::state() const {
  const Json& factor = at("factor_of_safety");
  return !factor.is_number() ? "not found" : factor.get<double>() < 1 ? "below 1" : "at least 1";
}

Verdict StrengthRecord::verdict() const {
  const Json& factor = at("factor_of_safety");
  if (factor.is_number()) return factor.get<double>() < 1 ? Verdict::bad : Verdict::good;
  const Json& stands = at("bracket.stands");
  return stands.is_number() && stands.get<double>() >= 1 ? Verdict::doubtful : Verdict::bad;
}

std::string StrengthRecord::words() const {
  const std::string factor = factor_text(at("factor_of_safety"));
  const std::string stands = factor_text(at("bracket.stands"));
  const std::string falls = factor_text(at("bracket.falls"));
  const std::string known =
      fmt::format("{}{}{}", stands.empty() ? "" : "stable at " + stands, stands.empty() || falls.empty() ? "" : ", ",
                  falls.empty() ? "" : "unstable at " + falls);
  if (factor.empty())
    return fmt::format("{}{}{}.",
                       at("end") == "stopped" ? "The search was stopped before it found a factor of safety"
                                              : "No factor of safety was found",
                       known.empty() ? "" : ": the model is ", known);
  const bool is_low = at("lower_estimate") == true;
  return fmt::format("Factor of safety {}{}: the model is {}, with the strength of {} divided by these factors.",
                     factor, is_low ? " (a lower estimate)" : "", known, reduced_in_words(json()));
}

std::string StrengthRecord::program() const {
  return fmt::format("Keyblock {}", plain_text(at("version")));
}

std::vector<report::DocumentPicture> strength_pictures(const fs::path& folder, std::size_t most) {
  return pictures_in(
      folder,
      {{"picture.svg", "Model at both ends of the bracket"}, {"fos.svg", "Largest displacement over the factor"}},
      most);
}

Handout strength_document(const fs::path& folder, const std::string& project) {
  const StrengthRecord record(folder);
  report::Document document{plain_text(member(record.json(), "case")) + ", factor of safety",
                            "Report of a search for the factor of safety",
                            record.verdict(),
                            record.words(),
                            {}};
  document.facts = facts_of(project, record.program(), folder / kStrengthRecord);
  add_if_filled(document.sections, {"Pictures", {}, strength_pictures(folder), {}});
  add_if_filled(document.sections, result_of(record));
  add_if_filled(document.sections, trials_of(record));
  add_if_filled(document.sections, material_section(record));
  add_if_filled(document.sections, warning_section(record));
  add_if_filled(document.sections, checksum_section(folder, record));
  add_anchors(document.sections);
  return {std::move(document), {}};
}

}  // namespace keyblock
