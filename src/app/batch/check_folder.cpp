// `keyblock check FOLDER`: checks every job of a folder and prints one verdict per line; writes no files.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <thread>
#include <vector>

#include "app/batch/batch_archive.hpp"
#include "app/command.hpp"
#include "base/counted.hpp"
#include "base/error.hpp"
#include "base/parallel.hpp"
#include "base/printable.hpp"
#include "formats/registry.hpp"
#include "study/batch/batch_catalogue.hpp"
#include "study/batch/batch_check.hpp"
#include "study/batch/batch_verdict.hpp"

namespace keyblock {
namespace {

using report::CatalogueRow;

CatalogueRow row_of_job(const std::string& folder, const FileTree& tree, const study::BatchJob& job,
                        const std::string& profile) {
  const std::string problem = tree.problem_of(job);
  if (!problem.empty()) return study::row_without_check(job, tree.files_of(job), "failed", problem);
  if (job.kind == study::JobKind::listed) return study::row_without_check(job, tree.files_of(job), "listed", "");
  return study::check_job(folder, job, tree.files_of(job), study::CheckDepth::plan, profile);
}

std::string line_of(const CatalogueRow& row) {
  std::string more;
  if (row.outcome == "ok") more = row.scene;
  if (row.outcome == "warnings")
    more = fmt::format("{}, the first: {}", counted(static_cast<std::size_t>(row.warnings), "warning"), row.message);
  if (row.outcome == "failed") more = row.message;
  if (row.outcome == "listed" && !row.files.empty())
    if (const formats::Format* format = formats::find_format(row.files.front().format)) more = format->title;
  return printable(fmt::format("{:<8}  {}{}{}", row.outcome, row.name, more.empty() ? "" : ": ", more));
}

}  // namespace

ExitCode check_folder(const std::string& folder, const std::string& profile, bool as_json) {
  const int threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  const FileTree tree = survey(folder, {}, kLargestMebibytes, threads);
  if (!tree.passed_over.empty()) spdlog::warn("skipped: {}", study::sentence_of(tree.passed_over));
  if (tree.jobs.empty()) throw InputError({folder}, "expected files of cases in the folder, found none");
  std::vector<CatalogueRow> rows(tree.jobs.size());
  for_each_in_parallel(rows.size(), threads, [&](std::size_t i) {
    rows[i] = row_of_job(folder, tree, tree.jobs[i], profile);
    rows[i].verdict = study::verdict_of(rows[i], study::BatchAim::check);
  });
  if (as_json) {
    fmt::print("{}\n", study::catalogue_json(rows));
  } else {
    for (const CatalogueRow& row : rows) fmt::print("{}\n", line_of(row));
    const auto count = [&](const char* outcome) { return std::ranges::count(rows, outcome, &CatalogueRow::outcome); };
    fmt::print("{}: {} ok, {} with warnings, {} failed, {} only listed\n", counted(rows.size(), "job"), count("ok"),
               count("warnings"), count("failed"), count("listed"));
  }
  const bool fails = std::ranges::find(rows, "failed", &CatalogueRow::outcome) != rows.end();
  return fails ? ExitCode::unreadable : ExitCode::ok;
}

}  // namespace keyblock
