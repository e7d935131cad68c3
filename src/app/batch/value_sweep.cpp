// `keyblock sweep`: runs a case under many values, each in a process of its own, and writes one table.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string_view>
#include <thread>

#include "api/case_values.hpp"
#include "api/named_files.hpp"
#include "api/plan.hpp"
#include "app/batch/engine_scripts.hpp"
#include "app/batch/journal_file.hpp"
#include "app/batch/shard.hpp"
#include "app/batch/shard_lock.hpp"
#include "app/batch/sweep_jobs.hpp"
#include "app/batch/sweep_results.hpp"
#include "app/input/value_sweep_options.hpp"
#include "app/stop_request.hpp"
#include "base/bytes/sha256.hpp"
#include "base/context.hpp"
#include "base/counted.hpp"
#include "base/error.hpp"
#include "base/parallel.hpp"
#include "formats/all_content.hpp"
#include "formats/registry.hpp"
#include "formats/strict_json.hpp"
#include "job/files.hpp"
#include "job/folder/made_by.hpp"
#include "job/folder/outputs_asked.hpp"
#include "run/cover_settings.hpp"
#include "run/follow/followed.hpp"
#include "settings/settings_table.hpp"
#include "study/sweep/varied_key.hpp"

namespace keyblock {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using study::SweepJournal;
using study::SweepResult;
using study::SweepRow;
using study::SweepTable;

/// Sweep that is ready to run.
struct ReadySweep {
  SweepPlan plan;
  std::vector<SweepRow> rows;
  std::vector<std::string> jobs;             ///< of each row
  std::map<std::string, std::string> named;  ///< checksum of the files that settings name, of each job
  std::string task;                          ///< all that determines a result apart from the row
  std::string case_text;                     ///< the case file in strict JSON
  Units units;                               ///< declared by the case
  Json inputs = Json::array();               ///< files read, with checksums
};

/// Returns what a key expects if that is whole numbers alone. The key is of a setting, of the case, or of the
/// statistics of joints.
std::string whole_numbers_of(const std::string& key, const std::string& case_text) {
  constexpr std::array<std::string_view, 4> kOfStatistics{"benches", "boundary_joint", "joint", "seed"};
  const bool is_of_joints = key.starts_with(study::kOfJoints);
  const std::string_view last = std::string_view(key).substr(key.rfind('/') + 1);
  const bool is_whole = is_of_joints ? std::ranges::find(kOfStatistics, last) != kOfStatistics.end()
                                     : key.starts_with('/') && takes_whole_numbers(key, case_text);
  if (is_whole) return key + ": expected a whole number";
  for (const SettingText& setting : list(Settings{}))
    if (setting.name == key && setting.permitted.whole)
      return fmt::format("setting {}: expected {}", key, setting.permitted.expected);
  return {};
}

/// Refuses fractions, such as those of a distribution, for keys that take whole numbers alone.
void require_whole_numbers(const std::vector<SweepRow>& rows, const std::string& case_text) {
  const auto is_fraction = [](const Json& value) {
    return value.is_number_float() && std::fmod(value.get<double>(), 1) != 0;
  };
  for (const auto& [key, first] : rows.front().items()) {
    const auto found = std::ranges::find_if(rows, [&](const SweepRow& row) { return is_fraction(row.at(key)); });
    if (found == rows.end()) continue;
    if (const std::string expected = whole_numbers_of(key, case_text); !expected.empty())
      throw UsageError(fmt::format("{}, found {}; a list has whole numbers, a distribution has not", expected,
                                   found->at(key).dump()));
  }
}

WordKind words_of(const std::string& key, const std::string& case_text) {
  if (key.starts_with('/')) return words_at(key, case_text);
  return key.starts_with(study::kOfJoints) ? WordKind::amount : words_of_setting(key);
}

std::vector<SweepRow> rows_asked(const ValueSweepOptions& options, const std::string& case_text) {
  if (!options.design_file.empty()) {
    if (!options.over.empty()) throw UsageError("sweep: expected --over or --design, found both");
    return study::rows_of_file(options.design_file, formats::load(options.design_file).text);
  }
  std::vector<study::VariedKey> keys;
  const auto words = [&](const std::string& key) { return words_of(key, case_text); };
  for (const std::string& over : options.over) keys.push_back(study::varied_key_of(over, words));
  const study::Design design = options.random > 0  ? study::Design::random
                               : options.is_zipped ? study::Design::zipped
                                                   : study::Design::grid;
  if (options.random > 0 && options.is_zipped) throw UsageError("sweep: expected --random or --zip, found both");
  return study::sweep_rows(keys, {design, options.random, options.seed});
}

void require_key_of_joints(const std::string& key, const std::string& joints) {
  try {
    pointers_to(key.substr(study::kOfJoints.size()), joints, true);
  } catch (const std::invalid_argument&) {
    throw UsageError(fmt::format("--over: expected joints: and a pointer to a value of --joints, found \"{}\"", key));
  }
}

/// Refuses keys that nothing has, before any job: pointers against the case and the statistics, settings by name.
void require_keys(const SweepRow& row, const std::string& case_text, const std::string& joints) {
  std::vector<std::string> settings;
  for (const SettingText& setting : list(Settings{})) settings.push_back(setting.name);
  for (const auto& [key, value] : row.items()) {
    if (key.starts_with('/')) {
      pointers_to(key, case_text, true);
    } else if (key.starts_with(study::kOfJoints)) {
      if (joints.empty()) throw UsageError(fmt::format("{}: expected --joints with the statistics, found none", key));
      require_key_of_joints(key, joints);
    } else if (std::ranges::find(settings, key) == settings.end() && !is_of_plan(key)) {
      throw UsageError(fmt::format(
          "--over: expected a pointer that begins with /, joints: with one, or a setting, found \"{}\"", key));
    }
  }
}

/// Refuses a history that no run follows. Rows that change the outputs of the case may have others.
void require_histories(const std::vector<study::SweepOutput>& outputs, const OutputPlan& plan, const SweepRow& row) {
  const auto is_of_outputs = [](const auto& item) { return item.key().starts_with("/outputs"); };
  if (plan.histories.empty() || std::ranges::any_of(row.items(), is_of_outputs)) return;
  std::vector<std::string> names;
  for (const HistoryPlan& history : with_names_apart(plan.histories)) names.push_back(name_of(history));
  for (const study::SweepOutput& output : outputs)
    if (!output.history.empty() && std::ranges::find(names, output.history) == names.end())
      throw UsageError(
          fmt::format("--out: expected a quantity of the history {}, found {}", fmt::join(names, ", "), output.name));
}

std::string task_of(const ValueSweepOptions& options, const OpenCase& open, const std::string& joints) {
  Json task = {{"version", KEYBLOCK_VERSION}, {"out", options.out},         {"profile", options.given.profile},
               {"set", options.given.sets},   {"at", options.given.values}, {"history", options.histories}};
  Json digests = Json::array();
  for (const formats::FileReading& file : open.read_files()) digests.push_back(sha256(file.source.text));
  if (!options.given.settings_file.empty()) digests.push_back(sha256(formats::load(options.given.settings_file).text));
  if (!open.file.path.empty() && fs::exists(open.file.path))
    digests.push_back(sha256(formats::load(open.file.path).text));
  if (!joints.empty()) digests.push_back(sha256(joints));
  task["files"] = digests;
  task["unit"] = options.given.reading.choices.unit;
  task["join"] = options.given.reading.choices.join;
  if (options.within) task["within"] = *options.within;
  task["limits"] = {options.cpu_seconds, options.memory_mebibytes};
  return task.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// Returns the settings of a row. Those of the case file name files from its folder.
std::vector<Override> settings_of_row(const SweepRow& row, const fs::path& folder) {
  std::vector<Override> settings;
  for (const auto& [key, value] : row.items()) {
    if (!value.is_string()) continue;
    const bool is_of_case = key.starts_with('/');
    const std::string name = is_of_case ? pointer_steps(key).back() : key;
    settings.emplace_back(name, is_of_case ? from_folder(folder, name, value) : value.get<std::string>());
  }
  return settings;
}

/// Finds the files that settings name. A row without its file fails by itself.
void find_named_files(ReadySweep& sweep, const OpenCase& open) {
  const std::vector<std::string> common = named_files(configured(open, open.input.problem));
  std::map<std::string, std::string> checksums;
  const fs::path folder = fs::path(open.read_files().front().path).parent_path();
  for (std::size_t i = 0; i < sweep.rows.size(); ++i) {
    std::vector<std::string> files = named_files(settings_of_row(sweep.rows[i], folder));
    files.insert(files.begin(), common.begin(), common.end());
    std::string all;
    for (const std::string& file : files) {
      const auto [known, is_new] = checksums.emplace(file, "");
      if (is_new && fs::is_regular_file(file)) known->second = checksum_of(file);
      all += known->second + "\n";
    }
    sweep.named[sweep.jobs[i]] = all.empty() ? all : sha256(all);
  }
  for (const auto& [file, checksum] : checksums)
    if (!checksum.empty()) sweep.inputs.push_back({{"file", file}, {"sha256", checksum}});
}

ReadySweep ready(const ValueSweepOptions& options) {
  ReadySweep sweep{{options.given,
                    {},
                    options.histories,
                    study::sweep_outputs_of(options.out),
                    options.within,
                    {options.cpu_seconds, options.memory_mebibytes},
                    options.folder},
                   {},
                   {},
                   {},
                   {},
                   {},
                   {}};
  if (!options.joints.empty()) sweep.plan.joints = formats::strict_json(formats::load(options.joints));
  const OpenCase open = opened(case_of(options.given));
  sweep.case_text = formats::case_file_text(open.input.files);
  sweep.units = open.input.problem.units;
  sweep.rows = rows_asked(options, sweep.case_text);
  require_keys(sweep.rows.front(), sweep.case_text, sweep.plan.joints);
  require_whole_numbers(sweep.rows, sweep.case_text);
  require_histories(sweep.plan.outputs, outputs_asked(open.input.problem.outputs, {options.histories, {}, {}}),
                    sweep.rows.front());
  for (const study::SweepOutput& output : sweep.plan.outputs)
    if (sweep.rows.front().contains(output.name))
      throw UsageError(fmt::format("--out: expected names that --over does not have, found {}", output.name));
  for (const std::string& file : open.files) require_not_below(file, options.folder);
  for (const SweepRow& row : sweep.rows) sweep.jobs.push_back(study::job_name(row));
  sweep.task = task_of(options, open, sweep.plan.joints);
  for (const formats::FileReading& file : open.read_files())
    sweep.inputs.push_back({{"file", file.path}, {"sha256", sha256(file.source.text)}});
  for (const std::string& file : {options.given.settings_file, open.file.path, options.joints, options.design_file})
    if (!file.empty() && fs::exists(file)) sweep.inputs.push_back({{"file", file}, {"sha256", checksum_of(file)}});
  find_named_files(sweep, open);
  return sweep;
}

/// Refuses a folder that holds something else than the design and the joints of this sweep. A shard may come first,
/// beside files of its own choice.
void require_sweep_folder(const ValueSweepOptions& options, const Shard& shard) {
  const fs::path folder = options.folder;
  if (!journals_in(folder).empty()) return;
  if (shard.is_whole() ? !is_free(folder, {options.design_file, options.joints}) : has_files_of_sweep(folder))
    throw UsageError(fmt::format("{} holds something that is no sweep; give another folder", folder.string()));
}

/// Returns the results in all journals of the folder, without those of other jobs and of files that changed since.
/// Throws UsageError if a journal belongs to another sweep.
std::map<std::string, SweepResult> known_results(const ReadySweep& sweep) {
  std::map<std::string, SweepResult> known;
  const fs::path& folder = sweep.plan.folder;
  for (const fs::path& file : journals_in(folder)) {
    const SweepJournal journal = study::read_sweep_journal(formats::load(file.string()).text);
    if (journal.task != sweep.task)
      throw UsageError(
          fmt::format("{} holds a sweep of another case, output or limit; give another folder", folder.string()));
    for (const auto& [job, result] : journal.results)
      if (const auto own = sweep.named.find(job); own != sweep.named.end() && own->second == result.files)
        known.emplace(job, result);
  }
  return known;
}

/// Opens the journal of this shard: a new one, or the whole lines of an earlier one.
void begin_journal(const ReadySweep& sweep, const fs::path& file) {
  SweepJournal journal;
  if (fs::exists(file)) journal = study::read_sweep_journal(formats::load(file.string()).text);
  if (journal.task.empty()) journal.add(study::sweep_journal_head(sweep.task));
  std::error_code error;
  fs::create_directories(sweep.plan.folder / "jobs", error);
  if (error) throw UsageError(fmt::format("cannot make the folder {}", sweep.plan.folder.string()));
  write_file(file, journal.lines);
}

/// Does the jobs of the shard that have no result, and adds their results to `known`.
void do_jobs(const ValueSweepOptions& options, const ReadySweep& sweep, const Shard& shard,
             std::map<std::string, SweepResult>& known) {
  std::vector<const SweepRow*> missing;
  std::set<std::string> taken, lacked;
  for (std::size_t i = 0; i < sweep.rows.size(); ++i)
    if (shard.has(sweep.jobs[i]) && !known.contains(sweep.jobs[i]) && taken.insert(sweep.jobs[i]).second)
      missing.push_back(&sweep.rows[i]);
  const fs::path file = sweep.plan.folder / shard.journal_name();
  begin_journal(sweep, file);
  const JournalFile journal(file);
  JobReports reports(missing.size());
  std::mutex guard;
  const Context stop = context();
  const int jobs = options.jobs > 0 ? options.jobs : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  for_each_in_parallel(missing.size(), jobs, [&](std::size_t i) {
    std::optional<SweepResult> result = do_sweep_job(sweep.plan, *missing[i], stop);
    if (!result) return;
    result->files = sweep.named.at(result->job);
    const std::string line = study::sweep_journal_line(*result);
    const std::scoped_lock lock(guard);
    journal.add(line);
    known.insert_or_assign(result->job,
                           study::read_sweep_journal(study::sweep_journal_head("row") + line).results.at(result->job));
    for (const auto& [name, why] : result->lacking.items())
      if (lacked.insert(name).second)
        spdlog::warn("job {}: {}; if no run has it, the sweep is refused", result->job, why.get<std::string>());
    reports.add_one();
  });
}

/// Returns the rows of a shard.
SweepTable of_shard(const SweepTable& table, const Shard& shard) {
  SweepTable part{table.outputs, {}, {}};
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    if (!shard.has(table.results[i].job)) continue;
    part.rows.push_back(table.rows[i]);
    part.results.push_back(table.results[i]);
  }
  return part;
}

/// Writes the table if all results are known.
ExitCode finish(const ValueSweepOptions& options, const ReadySweep& sweep, const Shard& shard,
                const std::map<std::string, SweepResult>& known) {
  SweepTable table{{}, {}, {}};
  for (const study::SweepOutput& output : sweep.plan.outputs) table.outputs.push_back(output.name);
  std::size_t missing = 0, missing_here = 0;
  for (std::size_t i = 0; i < sweep.rows.size(); ++i) {
    const auto found = known.find(sweep.jobs[i]);
    if (found != known.end()) {
      table.rows.push_back(sweep.rows[i]);
      table.results.push_back(found->second);
      continue;
    }
    ++missing;
    if (shard.has(sweep.jobs[i]) && !options.is_merged) ++missing_here;
  }
  if (missing_here > 0) {
    spdlog::warn("stopped; {} of {} runs are missing; the same command with --resume goes on", missing,
                 sweep.rows.size());
    return is_at_time_limit() ? ExitCode::limit : ExitCode::stopped;
  }
  if (missing > 0 && options.is_merged)
    throw UsageError(fmt::format("{}: {} of {} runs are missing; their shards have not ended", options.folder, missing,
                                 sweep.rows.size()));
  if (!shard.is_whole()) {
    if (options.as_json) {
      const SweepTable part = of_shard(table, shard);
      const bool is_empty = part.rows.empty();
      std::fputs((is_empty ? study::table_json(part, Json::object())
                           : sweep_json(part, sweep_columns(part, sweep.case_text, sweep.units)))
                     .c_str(),
                 stdout);
    }
    spdlog::info("shard {} of {} is done; --merge writes the table when all are", shard.k, shard.n);
    return ExitCode::ok;
  }
  require_outputs(table);
  const std::vector<SweepColumn> columns = sweep_columns(table, sweep.case_text, sweep.units);
  const Json seed = options.random > 0 ? Json(options.seed) : Json();
  const Json origin = {{"program", "keyblock"},
                       {"version", KEYBLOCK_VERSION},
                       {"made_by", made_by_json(seed)},
                       {"inputs", sweep.inputs}};
  write_sweep({options.folder, fs::path(options.given.paths.front()).filename().string(), origin}, table, columns);
  return print_sweep(options, table, columns);
}

}  // namespace

ExitCode sweep_values(const ValueSweepOptions& options) {
  if (options.over.empty() && options.design_file.empty())
    throw UsageError(
        "sweep: expected --over or --design, found neither; `keyblock tradeoff --map` maps errors over contact "
        "stiffness and step");
  if (options.folder.empty())
    throw UsageError("sweep: no folder given for the results; usage: keyblock sweep CASE --over KEY=VALUES -o FOLDER");
  const Shard shard = options.shard.empty() ? Shard{} : shard_of(options.shard);
  if (options.is_merged && !shard.is_whole()) throw UsageError("sweep: expected --shard or --merge, found both");
  if (options.force && !shard.is_whole())
    throw UsageError("sweep: --force would remove the results of other shards; expected --shard with --resume");
  const ReadySweep sweep = ready(options);
  if (options.slurm > 0 || options.parallel > 0) {
    fmt::print("{}", options.slurm > 0 ? slurm_script(own_command(), options.slurm)
                                       : parallel_line(own_command(), options.parallel));
    return ExitCode::ok;
  }
  require_sweep_folder(options, shard);
  listen_for_stops();
  std::optional<ShardLock> lock;
  if (!options.is_merged) lock.emplace(options.folder, shard);
  const bool goes_on = options.is_resumed || options.is_merged;
  if (options.force && !goes_on) remove_sweep(options.folder);
  std::map<std::string, SweepResult> known = known_results(sweep);
  if (!options.force && shard.is_whole()) require_no_larger_table(options.folder, sweep.jobs);
  if (fs::exists(sweep.plan.folder / shard.journal_name()) && !goes_on)
    throw UsageError(
        fmt::format("{} holds a sweep; --resume goes on with it, --force begins it again", options.folder));
  if (!options.is_merged) do_jobs(options, sweep, shard, known);
  return finish(options, sweep, shard, known);
}

}  // namespace keyblock
