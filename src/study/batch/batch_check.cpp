// Reads, pairs, checks, cuts and, on request, prepares a job as the commands `check` and `run` do.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/batch/batch_check.hpp"

#include <algorithm>
#include <new>
#include <variant>

#include "api/plan.hpp"
#include "base/words/diagnostics.hpp"
#include "base/words/replace_all.hpp"
#include "cut/bodies/cut_blocks.hpp"
#include "problem/checks/check.hpp"
#include "report/thumbnail.hpp"
#include "study/batch/batch_files.hpp"
#include "study/batch/scene_sentence.hpp"

namespace keyblock::study {

namespace fs = std::filesystem;

namespace {

using report::CatalogueRow;

std::vector<std::string> paths_of(const fs::path& root, const std::vector<std::string>& files) {
  std::vector<std::string> paths;
  for (const std::string& file : files) paths.push_back(place_of(root, file).string());
  return paths;
}

// Messages show names as in the archive. A path is at the start of a message or after a space.
std::string below(const fs::path& root, const BatchJob& job, std::string text) {
  for (const std::string& file : job.files)
    if (const std::string place = place_of(root, file).string(); place != (root / file).string())
      replace_all(text, place, (root / file).string());
  const std::string prefix = (root / "").string();
  for (std::size_t at = text.find(prefix); at != std::string::npos; at = text.find(prefix, at)) {
    if (at == 0 || text[at - 1] == ' ')
      text.erase(at, prefix.size());
    else
      ++at;
  }
  return text;
}

void draw(CatalogueRow& row, const Problem& problem, const Blocks& blocks) {
  if (problem.analysis) row.scene = scene_sentence(blocks, *problem.analysis);
  row.blocks = static_cast<int>(blocks.blocks.size());
  row.thumbnail = report::thumbnail(blocks);
}

// A drawing that closes no block is shown by its lines; the error reports the reason.
Warnings look_at_scene(CatalogueRow& row, const Problem& problem) {
  if (problem.analysis) row.steps = problem.analysis->step_count;
  if (const auto* blocks = std::get_if<Blocks>(&problem.geometry)) draw(row, problem, *blocks);
  if (const auto* cover = std::get_if<Cover>(&problem.geometry)) {
    row.elements = static_cast<int>(cover->elements.size());
    row.thumbnail = report::thumbnail(*cover);
    if (problem.analysis) row.scene = scene_sentence(*cover, *problem.analysis);
  }
  if (const auto* drawing = std::get_if<Drawing>(&problem.geometry)) {
    row.thumbnail = report::thumbnail(*drawing);
    const CutResult cut = cut_blocks(*drawing);
    draw(row, problem, cut.blocks);
    return cut.warnings;
  }
  return {};
}

// Returns the warnings that `run` and `check` give before the first step.
Warnings warnings_before_steps(const Problem& problem, const std::string& profile, CheckDepth depth,
                               const Warnings& of_cut) {
  try {
    AskedCase asked;
    asked.profile = profile;
    return planned(asked, problem).warnings;
  } catch (const InputError&) {
    if (depth == CheckDepth::plan) throw;
    return of_cut;
  }
}

// Results found before an exception stay in the row.
void follow(CatalogueRow& row, const std::vector<std::string>& paths, CheckDepth depth, const std::string& profile,
            Warnings& warnings) {
  std::vector<formats::Content> contents;
  std::optional<InputError> unread;
  for (const formats::FileReading& file : formats::read_files(paths)) {
    if (file.error && !unread) unread = file.error;
    if (!file.reading) continue;
    contents.push_back(file.reading->content);
    warnings = joined(std::move(warnings), file.reading->warnings);
  }
  const Checked checked = check(formats::pair(contents));
  warnings = joined(std::move(warnings), checked.warnings);
  if (unread) {
    look_at_scene(row, checked.problem);
    throw *unread;
  }
  if (!checked.errors.empty()) throw checked.errors.front();
  const Warnings of_cut = look_at_scene(row, checked.problem);
  const bool is_prepared = depth != CheckDepth::scene && can_prepare(checked.problem);
  warnings = joined(std::move(warnings),
                    is_prepared ? warnings_before_steps(checked.problem, profile, depth, of_cut) : of_cut);
}

}  // namespace

CatalogueRow row_without_check(const BatchJob& job, const std::vector<report::CatalogueFile>& files,
                               const std::string& outcome, const std::string& message) {
  CatalogueRow row;
  row.name = job.name;
  row.files = files;
  row.paired_by = job.paired_by;
  row.outcome = outcome;
  row.message = message;
  return row;
}

CatalogueRow check_job(const fs::path& root, const BatchJob& job, const std::vector<report::CatalogueFile>& files,
                       CheckDepth depth, const std::string& profile) {
  CatalogueRow row = row_without_check(job, files, "ok", "");
  Warnings warnings;
  try {
    follow(row, paths_of(root, job.files), depth, profile, warnings);
  } catch (const std::bad_alloc&) {
    row.outcome = "failed";
    row.message = "there is not enough memory for this";
  } catch (const std::exception& error) {
    row.outcome = "failed";
    row.message = below(root, job, error.what());
  }
  row.warnings = static_cast<int>(warnings.size());
  if (row.outcome == "ok" && !warnings.empty()) {
    row.outcome = "warnings";
    const auto first = std::ranges::find_if(
        warnings, [](const Warning& own) { return level_of(own.name) <= DiagnosticLevel::warning; });
    row.message = below(root, job, to_string(first == warnings.end() ? warnings.front() : *first));
  }
  return row;
}

bool fit_together(const fs::path& root, const BatchFile& geometry, const BatchFile& analysis) {
  try {
    const auto readings = formats::read_files(paths_of(root, {geometry.path, analysis.path}));
    if (!readings[0].reading || !readings[1].reading) return false;
    return counts_of(readings[0].reading->content) == counts_of(readings[1].reading->content);
  } catch (const std::bad_alloc&) {
    return false;
  }
}

}  // namespace keyblock::study
