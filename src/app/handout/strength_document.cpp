// Reads the record with a sentence for each end of the search.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/handout/strength_document.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/handout/record_reading.hpp"
#include "app/handout/sentences.hpp"
#include "base/bytes/file_bytes.hpp"
#include "base/error.hpp"
#include "base/words/diagnostics.hpp"
#include "base/words/plain_number.hpp"
#include "formats/text/csv.hpp"

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

// Returns the heading of the displacement with its unit, from the table of trials.
std::string displacement_heading(const fs::path& folder) {
  const fs::path file = folder / "trials.csv";
  if (fs::is_regular_file(file)) try {
      for (const std::string& heading : formats::read_csv({file.string(), file_bytes(file.string())}).header)
        if (heading.starts_with("largest_displacement")) return "largest" + heading.substr(7).replace(0, 1, " ");
    } catch (const InputError&) {
      return "largest displacement";
    }
  return "largest displacement";
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

DocumentSection trials_of(const StrengthRecord& record, const fs::path& folder) {
  Rows rows;
  Json trials = member(record.json(), "trials");
  if (!trials.is_array()) return {"Trials"};
  std::stable_sort(trials.begin(), trials.end(), [](const Json& a, const Json& b) {
    const Json &x = member(a, "factor"), &y = member(b, "factor");
    return x.is_number() && y.is_number() && x.get<double>() < y.get<double>();
  });
  for (const Json& trial : trials)
    rows.push_back({factor_text(member(trial, "factor")), state_of(plain_text(member(trial, "verdict"))),
                    plain_text(member(trial, "largest_displacement")), plain_text(member(trial, "why"))});
  return {"Trials", {}, {}, {{{"factor", "model", displacement_heading(folder), "reason"}, rows}}};
}

DocumentSection notes_of(const StrengthRecord& record) {
  DocumentSection section{"Warnings and notes"};
  for (const char* key : {"notes"})
    if (member(record.json(), key).is_array())
      for (const Json& note : member(record.json(), key)) section.paragraphs.push_back(sentence(plain_text(note)));
  Rows rows;
  if (member(record.json(), "warnings").is_array())
    for (const Json& warning : member(record.json(), "warnings")) {
      const std::string code = plain_text(member(warning, "name"));
      if (level_of(code) == DiagnosticLevel::silent) continue;
      const Diagnostic* known = find_diagnostic(code);
      rows.push_back({std::string(word_of(level_of(code))), plain_text(member(warning, "sentence")),
                      known ? std::string(known->remedy) : ""});
    }
  if (!rows.empty()) section.tables.push_back({{"level", "what was found", "what to do"}, rows});
  return section;
}

}  // namespace

StrengthRecord::StrengthRecord(const fs::path& folder) {
  const fs::path file = folder / kStrengthRecord;
  if (!fs::is_regular_file(file))
    throw InputError({folder.string()}, fmt::format("expected a folder with {}, found none", kStrengthRecord));
  json_ = Json::parse(file_bytes(file.string()), nullptr, false);
  if (!json_.is_object() || !json_.contains("bracket"))
    throw InputError({file.string()}, "expected the record of a search for the factor of safety, found another file");
}

Verdict StrengthRecord::verdict() const {
  const Json& factor = member(json_, "factor_of_safety");
  if (factor.is_number()) return factor.get<double>() < 1 ? Verdict::bad : Verdict::good;
  const Json& stands = member(member(json_, "bracket"), "stands");
  return stands.is_number() && stands.get<double>() >= 1 ? Verdict::doubtful : Verdict::bad;
}

std::string StrengthRecord::words() const {
  const std::string factor = factor_text(member(json_, "factor_of_safety"));
  const std::string stands = factor_text(member(member(json_, "bracket"), "stands"));
  const std::string falls = factor_text(member(member(json_, "bracket"), "falls"));
  const std::string known =
      fmt::format("{}{}{}", stands.empty() ? "" : "stable at " + stands, stands.empty() || falls.empty() ? "" : ", ",
                  falls.empty() ? "" : "unstable at " + falls);
  if (factor.empty())
    return fmt::format("No factor of safety was found{}{}.", known.empty() ? "" : ": the model is ", known);
  const bool is_low = member(json_, "lower_estimate") == true;
  return fmt::format("Factor of safety {}{}: the model is {}, with the strength of {} divided by these factors.",
                     factor, is_low ? " (a lower estimate)" : "", known, reduced_in_words(json_));
}

std::string StrengthRecord::program() const {
  return fmt::format("Keyblock {}", plain_text(member(json_, "version")));
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
  add_if_filled(document.sections, trials_of(record, folder));
  add_if_filled(document.sections, notes_of(record));
  add_anchors(document.sections);
  return {std::move(document), {}};
}

}  // namespace keyblock
