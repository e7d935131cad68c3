// Gathers results by case; a case has a card, rows of the table, and a section.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/handout/archive_document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "app/handout/run_document.hpp"
#include "app/handout/run_sections.hpp"
#include "app/handout/sentences.hpp"
#include "app/handout/strength_document.hpp"
#include "base/counted.hpp"
#include "base/error.hpp"
#include "job/folder/frame_files.hpp"
#include "job/folder/output_files.hpp"
#include "report/thumbnail.hpp"
#include "study/sweep/sweep_table.hpp"

namespace keyblock {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using report::Verdict;

constexpr std::size_t kLargestSmall = 300'000;     // bytes of a picture that a card shows whole
constexpr std::string_view kResults = "results ";  // in "results unreliable", where a count of results precedes it
constexpr std::size_t kMostWithPictures = 60;      // results; more would make a page of some hundred megabytes

std::vector<fs::path> results_below(const fs::path& folder) {
  std::vector<fs::path> results;
  const auto options = fs::directory_options::skip_permission_denied;
  for (auto entry = fs::recursive_directory_iterator(folder, options); entry != fs::recursive_directory_iterator();
       ++entry) {
    const fs::path name = entry->path().filename();
    if (name == kFrameFolder || study::is_of_a_sweep(entry->path())) entry.disable_recursion_pending();
    if (entry->is_regular_file() && (name == kRecord || name == kStrengthRecord))
      results.push_back(entry->path().parent_path());
  }
  std::ranges::sort(results);
  results.erase(std::ranges::unique(results).begin(), results.end());
  return results;
}

/// Holds the words of the report about one result.
struct Result {
  std::string name;
  std::string profile;
  Verdict verdict = Verdict::good;
  std::string state;  ///< verdict in words: "still moving", "factor below 1"
  std::string words;
  std::string answer = {};  ///< one line: "0.906 m after 100 steps", "factor of safety 3.29"
  std::vector<std::string> row = {};
  std::vector<std::string> paragraphs = {};
  std::vector<report::DocumentTable> warnings = {};
  std::string thumbnail = {};
  std::string program = {};
  std::string fault = {};
  bool is_of_strength = false;
};

Result run_result(const fs::path& folder, const std::string& name) {
  const RunRecordFile record(folder);
  const FrameState frames = frames_of(folder);
  const Judged judgement = judged(record, frames);
  const std::string moved = record.quantity("extremes.greatest_displacement.value", measures::kLength);
  const std::string steps = plain_text(record.at("outcome.steps"));
  Result result{name, record.text("profile"), judgement.verdict, judgement.state, judgement.words};
  result.answer = fmt::format("{} after {} steps", moved.empty() ? "no displacement" : moved, steps);
  result.row = {name, result.profile, result.state, steps, moved};
  result.paragraphs = {judgement.words};
  const Json& motion = record.list("outcome.motion.sentences");
  for (std::size_t i = 1; i < motion.size(); ++i)  // the verdict has the first
    result.paragraphs.push_back(sentence(plain_text(motion[i])));
  result.warnings = warning_section(record).tables;
  if (frames.last) result.thumbnail = report::thumbnail(*frames.last);
  result.program = program_of(record);
  if (!frames.fault.empty()) result.fault = fmt::format("{}: error: {}", folder.string(), frames.fault);
  return result;
}

Result strength_result(const fs::path& folder, const std::string& name) {
  const StrengthRecord record(folder);
  Result result{name, record.text("profile"), record.verdict(), fmt::format("factor {}", record.state()),
                record.words()};
  const Json& factor = record.at("factor_of_safety");
  result.answer = factor.is_number() ? fmt::format("factor of safety {:.3g}", factor.get<double>())
                                     : std::string("no factor of safety");
  result.row = {name, result.profile, result.answer, "", ""};
  result.paragraphs = {result.words};
  result.warnings = warning_section(record).tables;
  result.program = record.program();
  result.is_of_strength = true;
  for (report::DocumentPicture& picture : strength_pictures(folder, 1))
    if (picture.svg.size() < kLargestSmall) result.thumbnail = std::move(picture.svg);
  return result;
}

// A record that cannot be read is a result too: a client must learn that one is missing.
Result broken_result(const std::string& name, const std::string& why) {
  Result result{name, {}, Verdict::bad, "record broken", sentence("the record cannot be read: " + why)};
  result.row = {name, "", result.state, "", ""};
  result.paragraphs = {result.words};
  result.fault = why;
  return result;
}

Result result_in(const fs::path& folder, const std::string& name) {
  try {
    return fs::is_regular_file(folder / kRecord) ? run_result(folder, name) : strength_result(folder, name);
  } catch (const InputError& error) {
    return broken_result(name, error.what());
  }
}

// Returns the name of the case: the folder above for runs of one case by both profiles.
std::string case_of(const std::string& name, const std::string& profile) {
  const fs::path path = name;
  return path.has_parent_path() && path.filename() == profile ? path.parent_path().string() : name;
}

// Returns the name of a case without the folder in which a batch keeps its runs.
std::string title_of_case(const std::string& name) {
  constexpr std::string_view kJobs = "jobs/";
  return name.starts_with(kJobs) ? name.substr(kJobs.size()) : name;
}

report::DocumentCard card_of(const std::string& name, const std::vector<Result>& results) {
  report::DocumentCard card{title_of_case(name), name, {}, Verdict::good, results.front().state, {}};
  std::ranges::replace(card.anchor, ' ', '-');
  for (const Result& result : results) {
    if (result.verdict > card.verdict) card.state = result.state;
    card.verdict = std::max(card.verdict, result.verdict);
    if (card.svg.empty()) card.svg = result.thumbnail;
    if (!result.answer.empty()) card.lines.push_back(fmt::format("{}: {}", result.profile, result.answer));
    if (result.verdict != Verdict::good && !result.is_of_strength) card.lines.push_back(result.state);
  }
  return card;
}

std::string summary_of(const std::vector<Result>& results) {
  std::map<std::pair<Verdict, std::string>, std::size_t> counts;  // good ones first
  for (const Result& result : results) ++counts[{result.verdict, result.state}];
  std::string words = counted(results.size(), "result");
  for (const auto& [state, count] : counts) {
    const std::string_view what = state.second;  // "results unreliable": the word is there already
    words += fmt::format("{} {} {}", words.find(':') == std::string::npos ? ":" : ",", count,
                         what.substr(what.starts_with(kResults) ? kResults.size() : 0));
  }
  return words + ".";
}

report::DocumentSection section_of(const std::string& name, const std::vector<Result>& results, const fs::path& folder,
                                   bool has_pictures) {
  report::DocumentSection section{name};
  section.anchor = card_of(name, results).anchor;
  for (const Result& result : results) {
    for (const std::string& words : result.paragraphs)
      section.paragraphs.push_back(results.size() > 1 ? fmt::format("{}: {}", result.profile, words) : words);
    for (report::DocumentTable table : result.warnings) {
      if (results.size() > 1) table.columns[1] = fmt::format("{}, profile {}", table.columns[1], result.profile);
      section.tables.push_back(std::move(table));
    }
    if (!has_pictures) continue;
    const fs::path own = folder / result.name;
    for (report::DocumentPicture& picture : result.is_of_strength ? strength_pictures(own, 1) : run_pictures(own, 1)) {
      if (results.size() > 1) picture.caption = fmt::format("{}, profile {}", picture.caption, result.profile);
      section.pictures.push_back(std::move(picture));
    }
  }
  return section;
}

}  // namespace

Handout archive_document(const fs::path& folder, const std::string& project) {
  const std::vector<fs::path> found = results_below(folder);
  if (found.empty())
    throw InputError({folder.string()},
                     fmt::format("expected the folder of a run, or one of runs, with {}, found none", kRecord));
  std::vector<Result> results;
  std::map<std::string, std::vector<Result>> cases;
  Handout handout;
  report::Document& document = handout.document;
  std::vector<std::vector<std::string>> rows;
  for (const fs::path& path : found) {
    const std::string name = fs::relative(path, folder).string();
    const Result& result = results.emplace_back(result_in(path, name));
    cases[case_of(name, result.profile)].push_back(result);
    rows.push_back(result.row);
    if (!result.fault.empty()) handout.faults.push_back(result.fault);
    document.verdict = std::max(document.verdict, result.verdict);
  }
  document.title = fs::absolute(folder / ".").lexically_normal().parent_path().filename().string();
  document.subtitle = "Report of an archive";
  document.verdict_in_words = summary_of(results);
  const Result& earliest = results.front();
  const fs::path first = folder / earliest.name / (earliest.is_of_strength ? kStrengthRecord : kRecord);
  document.facts = facts_of(project, earliest.program, first);
  document.sections.push_back(
      {"Results", {}, {}, {{{"result", "profile", "verdict", "steps", "largest displacement"}, rows}}});
  const bool has_pictures = found.size() <= kMostWithPictures;
  if (!has_pictures)
    document.sections.front().paragraphs.push_back(fmt::format(
        "Pictures of single results are left out: an archive of more than {} has small ones only.", kMostWithPictures));
  for (const auto& [name, own] : cases) {
    document.cards.push_back(card_of(name, own));
    document.sections.push_back(section_of(name, own, folder, has_pictures));
  }
  return handout;
}

}  // namespace keyblock
