// Performs jobs. Results of a run or conversion go to jobs/NAME in the folder of results; files of an earlier attempt
// are removed.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/batch_work.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "api/case_folder.hpp"
#include "app/batch/logged_child.hpp"
#include "app/exit_code.hpp"
#include "base/bytes/sound_json.hpp"
#include "base/counted.hpp"
#include "base/error.hpp"
#include "formats/registry.hpp"
#include "job/run_report.hpp"
#include "settings/profile.hpp"
#include "study/batch/batch_answers.hpp"
#include "study/batch/batch_check.hpp"
#include "study/batch/batch_journal.hpp"
#include "study/batch/batch_verdict.hpp"
#include "study/convert/convert.hpp"

namespace keyblock {

namespace fs = std::filesystem;

namespace {

using report::CatalogueAnswer;
using report::CatalogueRow;

std::vector<std::string> profiles_of(const BatchPlan& plan) {
  return plan.profile.empty() ? std::vector<std::string>{"legacy", "standard"} : std::vector{plan.profile};
}

void fail(CatalogueRow& row, const std::string& message) {
  if (row.outcome != "failed") row.message = message;
  row.outcome = "failed";
}

void doubt(CatalogueRow& row, const std::string& message) {
  ++row.warnings;
  if (row.outcome != "ok") return;
  row.message = message;
  row.outcome = "warnings";
}

fs::path empty_folder_for(const BatchPlan& plan, const study::BatchJob& job) {
  return empty_folder(plan.folder / "jobs" / job.name);
}

std::vector<std::string> with_inputs(const std::string& verb, const BatchPlan& plan, const study::BatchJob& job) {
  std::vector<std::string> arguments{verb};
  for (const std::string& file : job.files) arguments.push_back(study::place_of(plan.root, file).string());
  return arguments;
}

/// Thrown by a job whose process was stopped with the batch.
struct JobStopped {};

ChildEnd run_logged(const BatchPlan& plan, const fs::path& folder, const std::string& name,
                    const std::vector<std::string>& arguments) {
  const ChildEnd end = run_logged(arguments, plan.limits, folder, name, plan.stop ? &*plan.stop : nullptr);
  if (has_been_stopped(end)) throw JobStopped();
  return end;
}

/// Runs the job under a profile. A run that was left unfinished goes on, unless its checkpoint does not fit any more.
ChildEnd run_or_resume(const BatchPlan& plan, const study::BatchJob& job, const fs::path& folder,
                       const std::string& profile) {
  const fs::path results = folder / profile;
  if (plan.is_resumed && fs::exists(results / "checkpoint.h5")) {
    const ChildEnd end = run_logged(plan, folder, profile, {"run", "--resume", results.string(), "--threads", "1"});
    if (end.exit_code != int(ExitCode::usage) && end.exit_code != int(ExitCode::unreadable)) return end;
  }
  std::error_code error;
  fs::remove_all(results, error);
  std::vector<std::string> arguments = with_inputs("run", plan, job);
  arguments.insert(arguments.end(), {"-o", results.string(), "--profile", profile, "--threads", "1"});
  return run_logged(plan, folder, profile, arguments);
}

CatalogueAnswer run_in(const BatchPlan& plan, const study::BatchJob& job, const fs::path& folder,
                       const std::string& profile, CatalogueRow& row) {
  const ChildEnd end = run_or_resume(plan, job, folder, profile);
  const bool came_to_its_end = end.exit_code == int(ExitCode::ok) || end.exit_code == int(ExitCode::check_failed);
  if (came_to_its_end) {
    CatalogueAnswer answer = study::answer_in(folder / profile, profile);
    if (!answer.doubt.empty()) doubt(row, fmt::format("{}: {}", profile, answer.doubt));
    return answer;
  }
  const std::string why = why_it_ended(end, plan.limits, folder / (profile + ".log"));
  CatalogueAnswer answer = study::answer_in(folder / profile, profile);
  const bool is_partial = end.ran_out_of_time && answer.has_result;
  // The check has read the case: Shi's rules lack something that it has, such as stages.
  if (plan.profile.empty() && profile == "legacy" && !answer.has_result && end.exit_code == int(ExitCode::unreadable)) {
    doubt(row, fmt::format("not run by {}: {}", profile, why));
    answer.end = why;
    return answer;
  }
  fail(row, fmt::format("{}: {}{}", profile, why, is_partial ? fmt::format(" after {} steps", answer.steps) : ""));
  if (!answer.has_result || is_partial) answer.end = why;
  return answer;
}

// Expected values belong to the case with the name of its folder.
bool is_the_case_of_its_folder(const BatchPlan& plan, const study::BatchJob& job) {
  const fs::path folder = study::place_of(plan.root, job.files.front()).parent_path();
  if (!fs::exists(folder / "expected.csv")) return false;
  const std::vector<std::string> inputs = CaseFolder{folder, {}, true, false}.inputs();
  return std::ranges::equal(inputs, job.files, [&](const std::string& input, const std::string& file) {
    return fs::path(input) == study::place_of(plan.root, file);
  });
}

std::string compare_with_expected(const BatchPlan& plan, const study::BatchJob& job, const fs::path& folder) {
  if (!is_the_case_of_its_folder(plan, job)) return {};
  const fs::path of_case = study::place_of(plan.root, job.files.front()).parent_path();
  std::vector<std::string> arguments{"compare", of_case.string(), "--json", "--all", "--threads", "1"};
  if (!plan.profile.empty()) arguments.insert(arguments.end(), {"--profile", plan.profile});
  const ChildEnd end = run_logged(plan, folder, "compare", arguments);
  return end.ran_out_of_time ? "not compared: the limit of processor time was reached"
                             : study::verdict_of(formats::load((folder / "compare.out").string()).text);
}

/// Returns true if an earlier batch left a run of the job unfinished.
bool is_begun(const BatchPlan& plan, const fs::path& folder) {
  return plan.is_resumed && std::ranges::any_of(profiles_of(plan), [&](const std::string& profile) {
           return fs::exists(folder / profile / "checkpoint.h5");
         });
}

void run_job(const BatchPlan& plan, const study::BatchJob& job, CatalogueRow& row) {
  const fs::path begun = plan.folder / "jobs" / job.name;
  const fs::path folder = is_begun(plan, begun) ? begun : empty_folder_for(plan, job);
  for (const std::string& profile : profiles_of(plan)) {
    row.answers.push_back(run_in(plan, job, folder, profile, row));
    row.outputs.push_back((fs::path("jobs") / job.name / profile).generic_string());
  }
  row.difference = study::difference_of(row.answers);
  row.expected = compare_with_expected(plan, job, folder);
}

study::CheckDepth depth_of(BatchTask task) {
  switch (task) {
    case BatchTask::check:
      return study::CheckDepth::plan;
    case BatchTask::run:
      return study::CheckDepth::outlook;
    case BatchTask::convert:
      return study::CheckDepth::scene;
  }
  return study::CheckDepth::scene;
}

CatalogueRow check_here(const BatchPlan& plan, const study::BatchJob& job,
                        const std::vector<report::CatalogueFile>& files) {
  return study::check_job(plan.root, job, files, depth_of(plan.task), plan.profile);
}

/// Checks in a separate process, `batch --row`, which prints a journal of this job alone.
CatalogueRow check_in_child(const BatchPlan& plan, const study::BatchJob& job,
                            const std::vector<report::CatalogueFile>& files) {
  const fs::path folder = plan.checks_folder() / job.name;
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw OutputError(fmt::format("cannot make {}: {}", folder.string(), error.message()));
  std::vector<std::string> arguments{"batch", plan.root.string()};
  if (plan.task == BatchTask::check) arguments.emplace_back("--check");
  if (plan.task == BatchTask::run) arguments.emplace_back("--run");
  if (!plan.profile.empty()) arguments.insert(arguments.end(), {"--profile", plan.profile});
  arguments.emplace_back("--row");
  arguments.insert(arguments.end(), job.files.begin(), job.files.end());
  const ChildEnd end = run_logged(plan, folder, "check", arguments);
  const study::Journal printed = study::read_journal(formats::load((folder / "check.out").string()).text);
  if (end.exit_code != 0 || printed.rows.size() != 1)
    return study::row_without_check(job, files, "failed", why_it_ended(end, plan.limits, folder / "check.log"));
  CatalogueRow row = printed.rows.begin()->second;
  row.name = job.name;
  row.files = files;
  row.paired_by = job.paired_by;
  return row;
}

/// Adds a warning to a successful job if the target format cannot hold all content.
void add_losses(CatalogueRow& row, const std::string& report) {
  const auto json = sound_json(report);
  if (!json.is_object() || !json.contains("losses") || json["losses"].empty()) return;
  const auto& losses = json["losses"];
  if (row.outcome == "ok")
    row.message = fmt::format("{} lost in the conversion, the first: {}: {}", counted(losses.size(), "thing"),
                              losses.front().value("item", ""), losses.front().value("change", ""));
  row.warnings += static_cast<int>(losses.size());
  row.outcome = "warnings";
}

void convert_job(const BatchPlan& plan, const study::BatchJob& job, CatalogueRow& row) {
  const fs::path folder = empty_folder_for(plan, job);
  const fs::path written = folder / "written";
  std::error_code error;
  if (!fs::create_directory(written, error))
    throw OutputError(fmt::format("cannot make {}: {}", written.string(), error.message()));
  const std::string_view ending = study::find_target(plan.format)->parts.front().ending;
  const fs::path output = written / (fs::path(job.files.front()).stem().string() + std::string(ending));
  std::vector<std::string> arguments = with_inputs("convert", plan, job);
  arguments.insert(arguments.end(), {"-o", output.string(), "--to", plan.format, "--json"});
  const ChildEnd end = run_logged(plan, folder, "convert", arguments);
  if (end.exit_code != 0) return fail(row, why_it_ended(end, plan.limits, folder / "convert.log"));
  add_losses(row, formats::load((folder / "convert.out").string()).text);
  for (const fs::directory_entry& entry : fs::directory_iterator(written))
    row.outputs.push_back(entry.path().lexically_relative(plan.folder).generic_string());
  std::ranges::sort(row.outputs);
}

}  // namespace

fs::path BatchPlan::checks_folder() const {
  return folder / "checks";
}

std::string BatchPlan::task_text() const {
  const std::string with_limits = fmt::format(", {} s, {} MiB", limits.cpu_seconds, limits.memory_mebibytes);
  switch (task) {
    case BatchTask::check:
      return fmt::format("keyblock {} check {}{}", KEYBLOCK_VERSION, profile, with_limits);
    case BatchTask::run:
      return fmt::format("keyblock {} run {}{}", KEYBLOCK_VERSION, fmt::join(profiles_of(*this), " "), with_limits);
    case BatchTask::convert:
      return fmt::format("keyblock {} convert {}{}", KEYBLOCK_VERSION, format, with_limits);
  }
  return {};
}

namespace {

CatalogueRow done_job(const BatchPlan& plan, const study::BatchJob& job,
                      const std::vector<report::CatalogueFile>& files) {
  if (job.kind == study::JobKind::listed) return study::row_without_check(job, files, "listed", "");
  const bool is_limited = plan.limits.cpu_seconds > 0 || plan.limits.memory_mebibytes > 0;
  CatalogueRow row = is_limited ? check_in_child(plan, job, files) : check_here(plan, job, files);
  const bool is_runnable = job.kind == study::JobKind::whole && row.outcome != "failed";
  if (plan.task == BatchTask::run && is_runnable) run_job(plan, job, row);
  if (plan.task == BatchTask::convert && row.outcome != "failed") convert_job(plan, job, row);
  return row;
}

study::BatchAim aim_of(BatchTask task) {
  switch (task) {
    case BatchTask::check:
      return study::BatchAim::check;
    case BatchTask::run:
      return study::BatchAim::run;
    case BatchTask::convert:
      return study::BatchAim::convert;
  }
  return study::BatchAim::check;
}

}  // namespace

std::optional<CatalogueRow> do_job(const BatchPlan& plan, const study::BatchJob& job,
                                   const std::vector<report::CatalogueFile>& files) {
  try {
    CatalogueRow row = done_job(plan, job, files);
    row.verdict = study::verdict_of(row, aim_of(plan.task));
    return row;
  } catch (const JobStopped&) {
    return std::nullopt;
  }
}

}  // namespace keyblock
