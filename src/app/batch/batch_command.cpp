// `keyblock batch`: checks, runs or converts every case of an archive, with a journal for resuming and a catalogue.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <fmt/format.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <mutex>
#include <thread>

#include "app/batch/batch_archive.hpp"
#include "app/batch/batch_work.hpp"
#include "app/command.hpp"
#include "app/option_checks.hpp"
#include "app/progress.hpp"
#include "app/stop_request.hpp"
#include "base/context.hpp"
#include "base/error.hpp"
#include "base/parallel.hpp"
#include "formats/registry.hpp"
#include "job/files.hpp"
#include "job/run_report.hpp"
#include "settings/profile.hpp"
#include "study/batch/batch_catalogue.hpp"
#include "study/batch/batch_check.hpp"
#include "study/batch/batch_journal.hpp"
#include "study/convert/convert.hpp"

namespace keyblock {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using report::CatalogueRow;

constexpr auto kBetweenReports = std::chrono::seconds(5);

struct BatchOptions {
  std::string root;
  std::string folder;
  bool is_check = false;
  bool is_run = false;
  std::string format;  ///< to convert to; empty: none
  std::string profile;
  int threads = 0;  ///< 0: as many as cores
  int largest_mebibytes = kLargestMebibytes;
  ChildLimits limits;
  std::vector<std::string> row_files;  ///< of one job; only its row is printed
  bool may_overwrite = false;
  bool as_json = false;
  bool is_resumed = false;
};

BatchPlan plan_of(const BatchOptions& options) {
  if ((options.is_check ? 1 : 0) + (options.is_run ? 1 : 0) + (options.format.empty() ? 0 : 1) != 1)
    throw UsageError("batch: expected one of --check, --run and --convert FORMAT");
  if (options.folder.empty()) throw UsageError("batch: expected -o OUT for the catalogue and the results");
  const std::string format = options.format.empty() ? "" : std::string(study::target_named(options.format).name);
  const BatchTask task = options.is_check ? BatchTask::check : options.is_run ? BatchTask::run : BatchTask::convert;
  return {task, fs::path(options.root), options.folder, options.profile, format, options.limits};
}

int thread_count(const BatchOptions& options) {
  return options.threads > 0 ? options.threads : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

/// Opens journal.jsonl at its end. A line is written by one call, so that a sudden end damages at most the last one.
class JournalFile {
 public:
  explicit JournalFile(const fs::path& file) : name_(file.string()) {
    descriptor_ = open(name_.c_str(), O_WRONLY | O_APPEND);
    if (descriptor_ < 0) throw OutputError(fmt::format("cannot write {}", name_));
  }
  ~JournalFile() { close(descriptor_); }
  JournalFile(const JournalFile&) = delete;
  JournalFile& operator=(const JournalFile&) = delete;

  void add(const std::string& line) const {
    if (write(descriptor_, line.data(), line.size()) != static_cast<ssize_t>(line.size()))
      throw OutputError(fmt::format("cannot write {}", name_));
  }

 private:
  std::string name_;
  int descriptor_;
};

bool lies_in(const fs::path& inner, const fs::path& outer) {
  const fs::path below = fs::weakly_canonical(inner).lexically_relative(fs::weakly_canonical(outer));
  return !below.empty() && *below.begin() != "..";
}

/// Returns the journal of an earlier batch in the folder; empty if there was no batch. Throws UsageError if results
/// could overwrite other files.
study::Journal journal_in(const BatchPlan& plan) {
  if (lies_in(plan.root, plan.folder))
    throw UsageError(fmt::format("{} lies in the folder for the results; give another folder", plan.root.string()));
  const fs::path file = plan.folder / "journal.jsonl";
  if (!fs::exists(plan.folder) || fs::is_empty(plan.folder)) return {};
  study::Journal journal;
  if (fs::exists(file)) journal = study::read_journal(formats::load(file.string()).text);
  if (journal.task.empty())
    throw UsageError(fmt::format("{} holds something that is no batch; give another folder", plan.folder.string()));
  return journal;
}

/// Removes the results of an earlier batch: next to a new journal they would look like its own.
void remove_results(const fs::path& folder, const study::Journal& journal) {
  std::error_code ignored;
  for (const auto& [job, row] : journal.rows) {
    const fs::path own = fs::path("jobs") / job;
    if (!lies_in(folder / own, folder / "jobs")) continue;
    fs::remove_all(folder / own, ignored);
    for (fs::path parent = own.parent_path(); parent.has_parent_path(); parent = parent.parent_path())
      fs::remove(folder / parent, ignored);  // unless it holds other files
  }
  fs::remove(folder / "jobs", ignored);
  for (const char* name : {"catalogue.csv", "catalogue.json", "catalogue.html"}) fs::remove(folder / name);
}

/// Returns the completed rows if this batch resumes an earlier one of the same task. Leaves whole lines on the disk.
study::Journal begun_journal(const BatchOptions& options, const BatchPlan& plan) {
  const std::string task = plan.task_text();
  study::Journal journal = journal_in(plan);
  if (!journal.task.empty() && !options.is_resumed && !options.may_overwrite)
    throw UsageError(
        fmt::format("{} contains a batch; --resume continues it, --force starts it again", plan.folder.string()));
  if (!journal.task.empty() && !options.is_resumed) remove_results(plan.folder, journal);
  if (!options.is_resumed) journal = {};
  if (!journal.task.empty() && journal.task != task)
    throw UsageError(fmt::format("{} holds a batch of another task ({}, now {}); give another folder",
                                 plan.folder.string(), journal.task, task));
  if (journal.task.empty()) journal.add(study::journal_head(task));
  std::error_code error;
  fs::create_directories(plan.folder, error);
  if (error) throw UsageError(fmt::format("cannot make the folder {}", plan.folder.string()));
  remove_drafts(plan.folder);
  write_file(plan.folder / "journal.jsonl", journal.lines);
  return journal;
}

/// Reports the progress of the batch at intervals, and the time left if the other jobs take as long.
class Reports {
 public:
  explicit Reports(std::size_t jobs) : jobs_(jobs) {}
  void add_one() {
    ++done_;
    if (Clock::now() - shown_ < kBetweenReports) return;
    shown_ = Clock::now();
    const double taken = std::chrono::duration<double>(Clock::now() - begun_).count();
    const double left = taken * static_cast<double>(jobs_ - done_) / static_cast<double>(done_);
    spdlog::info("{} of {} jobs done, about {} left", done_, jobs_, time_in_words(left));
  }

 private:
  std::size_t jobs_;
  std::size_t done_ = 0;
  Clock::time_point begun_ = Clock::now();
  Clock::time_point shown_ = begun_;
};

/// Does the jobs that are missing in the journal, and writes their rows.
void do_jobs(const BatchOptions& options, const BatchPlan& plan, const FileTree& archive, study::Journal& journal) {
  std::vector<const study::BatchJob*> open_jobs;
  for (const study::BatchJob& job : archive.jobs)
    if (journal.find(job.name, archive.files_of(job)) == nullptr) open_jobs.push_back(&job);
  if (options.is_resumed)
    spdlog::info("{} done before, {} to do", counted(archive.jobs.size() - open_jobs.size(), "job"), open_jobs.size());
  const JournalFile file(plan.folder / "journal.jsonl");
  Reports reports(open_jobs.size());
  std::mutex guard;
  for_each_in_parallel(open_jobs.size(), thread_count(options), [&](std::size_t i) {
    const Context own;  // on a stop, jobs that have begun still finish
    const Under under(own);
    const study::BatchJob& job = *open_jobs[i];
    const Clock::time_point start = Clock::now();
    const std::string problem = archive.problem_of(job);
    CatalogueRow row = problem.empty() ? do_job(plan, job, archive.files_of(job))
                                       : study::row_without_check(job, archive.files_of(job), "failed", problem);
    if (!problem.empty()) row.verdict = {"failed", problem};
    const std::string line = study::journal_line(row, std::chrono::duration<double>(Clock::now() - start).count());
    const std::scoped_lock lock(guard);
    file.add(line);
    journal.add(line);
    reports.add_one();
  });
}

/// Prints the row that a batch with limits requests of one process per job: the journal of a batch of that job alone.
ExitCode print_row(const BatchOptions& options) {
  const auto depth = options.is_check ? study::CheckDepth::plan
                     : options.is_run ? study::CheckDepth::outlook
                                      : study::CheckDepth::scene;
  study::BatchJob job;
  job.files = options.row_files;
  const CatalogueRow row = study::check_job(options.root, job, {}, depth, options.profile);
  fmt::print("{}{}", study::journal_head("row"), study::journal_line(row, 0));
  return ExitCode::ok;
}

// Rows come from the journal's lines, new or old, so that both give the same bytes.
std::vector<CatalogueRow> rows_of(const FileTree& archive, const study::Journal& journal) {
  std::vector<CatalogueRow> rows;
  for (const study::BatchJob& job : archive.jobs) {
    const CatalogueRow* row = journal.find(job.name, archive.files_of(job));
    if (row == nullptr) throw OutputError(fmt::format("journal.jsonl does not hold {}, which was done", job.name));
    rows.push_back(*row);
  }
  return rows;
}

void write_catalogue(const BatchPlan& plan, const std::vector<CatalogueRow>& rows) {
  write_file(plan.folder / "catalogue.csv", study::catalogue_csv(rows));
  write_file(plan.folder / "catalogue.json", study::catalogue_json(rows));
  const std::string title =
      fmt::format("Catalogue of {}", fs::absolute(plan.root / "").lexically_normal().parent_path().filename().string());
  write_file(plan.folder / "catalogue.html", report::catalogue_page(title, rows));
}

ExitCode run_batch(const BatchOptions& options) {
  if (!options.row_files.empty()) return print_row(options);
  const BatchPlan plan = plan_of(options);
  listen_for_stops();  // a stopped batch can resume from its journal
  const FileTree archive = survey(plan.root, plan.folder, options.largest_mebibytes, thread_count(options));
  if (!archive.passed_over.empty()) spdlog::warn("skipped: {}", study::sentence_of(archive.passed_over));
  study::Journal journal = begun_journal(options, plan);
  do_jobs(options, plan, archive, journal);
  std::error_code is_no_matter;
  fs::remove_all(plan.checks_folder(), is_no_matter);
  // A stop requested during the last job leaves no job undone.
  const bool is_done = std::ranges::all_of(archive.jobs, [&](const study::BatchJob& job) {
    return journal.find(job.name, archive.files_of(job)) != nullptr;
  });
  if (context().is_stopped() && !is_done) {
    spdlog::warn("stopped by request; the same command with --resume continues");
    return ExitCode::stopped;
  }
  const std::vector<CatalogueRow> rows = rows_of(archive, journal);
  write_catalogue(plan, rows);
  spdlog::info("{}, {}; {} with warnings; catalogue in {}", counted(archive.files.size(), "file"),
               report::summary_of(rows),
               std::ranges::count_if(rows, [](const CatalogueRow& row) { return row.warnings > 0; }), options.folder);
  if (options.as_json) fmt::print("{}\n", study::catalogue_json(rows));
  return std::ranges::count(rows, "failed", &CatalogueRow::outcome) == 0 ? ExitCode::ok : ExitCode::check_failed;
}

}  // namespace

Action configure_batch(CLI::App& app) {
  const auto options = std::make_shared<BatchOptions>();
  app.add_option("DIR", options->root, "folder of the archive")->required();
  app.add_option("-o,--output", options->folder,
                 "folder for catalogue.csv, .json and .html, journal.jsonl and results (required)")
      ->type_name("FOLDER");
  app.add_flag("--check", options->is_check,
               "check every case: contents, warnings, errors (one of --check, --run and --convert is required)");
  app.add_flag("--run", options->is_run, "run every case under the profiles legacy and standard and compare them");
  app.add_option("--convert", options->format, "convert every case to this format, as `keyblock convert --to`");
  app.add_option("--profile", options->profile, "use only this profile")->check(one_word_of(profile_names()));
  app.add_option("--jobs", options->threads, "jobs at a time (default: number of cores)")->check(CLI::Range(1, 1024));
  app.add_option("--time-limit", options->limits.cpu_seconds,
                 "processor time per check and per process of --run and --convert, seconds (default: no limit)")
      ->check(above_zero());
  app.add_option("--memory-limit", options->limits.memory_mebibytes,
                 "address space for each of them, MiB (default: no limit)")
      ->check(above_zero());
  app.add_option("--largest-file", options->largest_mebibytes, "files larger than N MiB are listed, not read")
      ->capture_default_str()
      ->check(above_zero());
  app.add_option("--row", options->row_files)->group("");  // internal: not in the help
  app.add_flag("--resume", options->is_resumed, "continue the batch in FOLDER; jobs with changed files are repeated");
  app.add_flag("--force", options->may_overwrite, "start the batch in FOLDER again");
  app.add_flag("--json", options->as_json, "also print catalogue.json on standard output");
  return [options] { return run_batch(*options); };
}

}  // namespace keyblock
