// `keyblock batch`: checks, runs or converts every case of an archive, with a journal for resuming and a catalogue.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/batch/batch_archive.hpp"
#include "app/batch/batch_work.hpp"
#include "app/batch/engine_scripts.hpp"
#include "app/batch/journal_file.hpp"
#include "app/batch/shard.hpp"
#include "app/batch/shard_lock.hpp"
#include "app/command.hpp"
#include "app/option_checks.hpp"
#include "app/stop_request.hpp"
#include "base/context.hpp"
#include "base/counted.hpp"
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

struct BatchOptions {
  std::string root;
  std::string folder;
  bool is_list = false;
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
  std::string shard_words;
  Shard shard = {};
  bool is_merged = false;
  int slurm = 0;     ///< number of shards of a script to print
  int parallel = 0;  ///< number of shards of a line to print
};

BatchPlan plan_of(const BatchOptions& options) {
  if ((options.is_check ? 1 : 0) + (options.is_run ? 1 : 0) + (options.format.empty() ? 0 : 1) != 1)
    throw UsageError("batch: expected one of --check, --run, --convert FORMAT and --list");
  if (options.folder.empty()) throw UsageError("batch: expected -o OUT for the catalogue and the results");
  const std::string format = options.format.empty() ? "" : std::string(study::target_named(options.format).name);
  const BatchTask task = options.is_check ? BatchTask::check : options.is_run ? BatchTask::run : BatchTask::convert;
  BatchPlan plan{task, fs::path(options.root), options.folder, options.profile, format, options.limits};
  plan.is_resumed = options.is_resumed;
  if (!options.shard.is_whole()) plan.stop = context();  // a queue ends a shard within a minute
  return plan;
}

int thread_count(const BatchOptions& options) {
  return options.threads > 0 ? options.threads : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

bool lies_in(const fs::path& inner, const fs::path& outer) {
  const fs::path below = fs::weakly_canonical(inner).lexically_relative(fs::weakly_canonical(outer));
  return !below.empty() && *below.begin() != "..";
}

/// Returns the journal of an earlier batch in the folder; empty if there was no batch. Throws UsageError if results
/// could overwrite other files.
study::Journal journal_in(const BatchPlan& plan, const Shard& shard) {
  if (lies_in(plan.root, plan.folder))
    throw UsageError(fmt::format("{} lies in the folder for the results; give another folder", plan.root.string()));
  const fs::path file = plan.folder / shard.journal_name();
  if (is_free(plan.folder)) return {};
  study::Journal journal;
  if (fs::exists(file)) journal = study::read_journal(formats::load(file.string()).text);
  if (journal.task.empty() && shard.is_whole())
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
  study::Journal journal = journal_in(plan, options.shard);
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
  if (options.shard.is_whole()) remove_drafts(plan.folder);
  write_file(plan.folder / options.shard.journal_name(), journal.lines);
  return journal;
}

/// Does the jobs that are missing in the journal, and writes their rows.
void do_jobs(const BatchOptions& options, const BatchPlan& plan, const FileTree& archive, study::Journal& journal) {
  std::vector<const study::BatchJob*> open_jobs;
  for (const study::BatchJob& job : archive.jobs)
    if (options.shard.has(job.name) && journal.find(job.name, archive.files_of(job)) == nullptr)
      open_jobs.push_back(&job);
  if (options.is_resumed && options.shard.is_whole())
    spdlog::info("{} done before, {} to do", counted(archive.jobs.size() - open_jobs.size(), "job"), open_jobs.size());
  const JournalFile file(plan.folder / options.shard.journal_name());
  JobReports reports(open_jobs.size());
  std::mutex guard;
  for_each_in_parallel(open_jobs.size(), thread_count(options), [&](std::size_t i) {
    const Context own;  // on a stop, jobs that have begun still finish
    const Under under(own);
    const study::BatchJob& job = *open_jobs[i];
    const Clock::time_point start = Clock::now();
    const std::string problem = archive.problem_of(job);
    std::optional<CatalogueRow> row = problem.empty()
                                          ? do_job(plan, job, archive.files_of(job))
                                          : study::row_without_check(job, archive.files_of(job), "failed", problem);
    if (!row) return;  // stopped: it goes on with --resume
    if (!problem.empty()) row->verdict = {"failed", problem};
    const std::string line = study::journal_line(*row, std::chrono::duration<double>(Clock::now() - start).count());
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

/// Returns true if the journal has a row of every job of the shard.
bool is_done(const FileTree& archive, const study::Journal& journal, const Shard& shard) {
  return std::ranges::all_of(archive.jobs, [&](const study::BatchJob& job) {
    return !shard.has(job.name) || journal.find(job.name, archive.files_of(job)) != nullptr;
  });
}

/// Returns the rows of the archive in the journals of all shards; rows of other or changed files stay out. Throws
/// UsageError if one belongs to another task.
study::Journal merged_journal(const BatchPlan& plan, const FileTree& archive) {
  study::Journal all;
  for (const fs::path& file : journals_in(plan.folder)) {
    const study::Journal journal = study::read_journal(formats::load(file.string()).text);
    if (journal.task != plan.task_text())
      throw UsageError(
          fmt::format("{} belongs to another task ({}, now {})", file.string(), journal.task, plan.task_text()));
    all.task = journal.task;
    for (const study::BatchJob& job : archive.jobs)
      if (const CatalogueRow* row = journal.find(job.name, archive.files_of(job)); row != nullptr)
        all.rows.insert_or_assign(job.name, *row);
  }
  if (!is_done(archive, all, {}))
    throw UsageError(fmt::format("{}: jobs are missing; their shards have not ended", plan.folder.string()));
  return all;
}

ExitCode finish(const BatchOptions& options, const BatchPlan& plan, const FileTree& archive,
                const study::Journal& journal) {
  const std::vector<CatalogueRow> rows = rows_of(archive, journal);
  write_catalogue(plan, rows);
  spdlog::info("{}, {}; {} with warnings; catalogue in {}", counted(archive.files.size(), "file"),
               report::summary_of(rows),
               std::ranges::count_if(rows, [](const CatalogueRow& row) { return row.warnings > 0; }), options.folder);
  if (options.as_json) fmt::print("{}\n", study::catalogue_json(rows));
  return std::ranges::count(rows, "failed", &CatalogueRow::outcome) == 0 ? ExitCode::ok : ExitCode::check_failed;
}

/// Prints the cases of the archive that can be run.
ExitCode list_cases(const BatchOptions& options) {
  nlohmann::ordered_json cases = nlohmann::ordered_json::array();
  for (const study::BatchJob& job : survey(options.root, {}, options.largest_mebibytes, thread_count(options)).jobs) {
    if (job.kind != study::JobKind::whole) continue;
    if (!options.as_json) fmt::print("{}\n", fmt::join(job.files, " "));
    std::vector<std::string> files;
    for (const std::string& file : job.files) files.push_back(study::place_of(options.root, file).string());
    cases.push_back({{"name", job.name}, {"files", files}, {"paired_by", job.paired_by}});
  }
  if (options.as_json) fmt::print("{}\n", cases.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
  return ExitCode::ok;
}

ExitCode run_batch(const BatchOptions& given) {
  if (!given.row_files.empty()) return print_row(given);
  if (given.is_list) return list_cases(given);
  BatchOptions options = given;
  if (!options.shard_words.empty()) options.shard = shard_of(options.shard_words);
  const BatchPlan plan = plan_of(options);
  if (options.slurm > 0 || options.parallel > 0) {
    fmt::print("{}", options.slurm > 0 ? slurm_script(own_command(), options.slurm)
                                       : parallel_line(own_command(), options.parallel));
    return ExitCode::ok;
  }
  listen_for_stops();  // a stopped batch can resume from its journal
  const FileTree archive = survey(plan.root, plan.folder, options.largest_mebibytes, thread_count(options));
  if (context().is_stopped()) {
    spdlog::warn("stopped before all files were read; the same command begins again");
    return is_at_time_limit() ? ExitCode::limit : ExitCode::stopped;
  }
  if (options.is_merged) return finish(options, plan, archive, merged_journal(plan, archive));
  if (!archive.passed_over.empty()) spdlog::warn("skipped: {}", study::sentence_of(archive.passed_over));
  journal_in(plan, options.shard);  // refuses a foreign folder before anything is written
  const ShardLock lock(plan.folder, options.shard);
  study::Journal journal = begun_journal(options, plan);
  do_jobs(options, plan, archive, journal);
  std::error_code is_no_matter;
  if (options.shard.is_whole()) fs::remove_all(plan.checks_folder(), is_no_matter);
  // A stop requested during the last job leaves no job undone.
  if (!is_done(archive, journal, options.shard)) {
    spdlog::warn("stopped by request; the same command with --resume continues");
    return is_at_time_limit() ? ExitCode::limit : ExitCode::stopped;
  }
  if (options.shard.is_whole()) return finish(options, plan, archive, journal);
  spdlog::info("shard {} of {} is done; --merge writes the catalogue when all are", options.shard.k, options.shard.n);
  return ExitCode::ok;
}

}  // namespace

Action configure_batch(CLI::App& app) {
  const auto options = std::make_shared<BatchOptions>();
  app.add_option("DIR", options->root, "folder of the archive")->required();
  app.add_option("-o,--output", options->folder,
                 "folder for catalogue.csv, .json and .html, journal.jsonl and results (required)")
      ->type_name("FOLDER");
  app.add_flag(
      "--check", options->is_check,
      "check every case: contents, warnings, errors (one of --check, --run, --convert and --list is required)");
  app.add_flag("--run", options->is_run, "run every case under the profiles legacy and standard and compare them");
  app.add_option("--convert", options->format, "convert every case to this format, as `keyblock convert --to`");
  app.add_flag("--list", options->is_list, "print the files of each case that can be run, and run nothing")
      ->excludes("--check")
      ->excludes("--run")
      ->excludes("--convert");
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
  CLI::Option* shard =
      app.add_option("--shard", options->shard_words, "do only jobs of shard K of N, also on another machine")
          ->type_name("K/N");
  app.add_flag("--merge", options->is_merged, "run nothing; write the catalogue of all shards in FOLDER")
      ->excludes(shard);
  app.add_option("--slurm", options->slurm, "print an array script of N shards for sbatch, and run nothing")
      ->type_name("N")
      ->check(CLI::Range(1, 100'000));
  app.add_option("--parallel", options->parallel, "print a line of N shards for GNU parallel, and run nothing")
      ->type_name("N")
      ->check(CLI::Range(1, 100'000));
  app.add_flag("--json", options->as_json, "also print catalogue.json on standard output");
  return [options] { return run_batch(*options); };
}

}  // namespace keyblock
