// Builds the command lines of a job, and reads what its processes leave.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/sweep_jobs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <nlohmann/json.hpp>
#include <string_view>

#include "api/case_values.hpp"
#include "app/batch/logged_child.hpp"
#include "app/exit_code.hpp"
#include "base/error.hpp"
#include "base/words/diagnostics.hpp"
#include "base/words/replace_all.hpp"
#include "formats/registry.hpp"
#include "job/files.hpp"
#include "job/folder/frame_files.hpp"

namespace keyblock {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using study::SweepOutput;
using study::SweepResult;
using study::SweepRow;
using study::SweepSource;

/// Processes of one job. Each member function returns false if no more of them should run.
class SweepJob {
 public:
  SweepJob(const SweepPlan& plan, const SweepRow& row, const Context& stop) : plan_(plan), row_(row), stop_(stop) {
    result_.job = study::job_name(row);
    folder_ = plan.folder_of(result_.job);
  }

  std::optional<SweepResult> done() {
    const auto began = std::chrono::steady_clock::now();
    if (!is_resumable()) empty_folder(folder_);
    bool goes_on = draw_joints() && run();
    for (const SweepOutput& output : plan_.outputs)
      goes_on = goes_on && (output.source != SweepSource::fos || find_safety(output));
    if (goes_on) find_intensities();
    if (is_stopped_) return std::nullopt;
    result_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    return result_;
  }

 private:
  fs::path run_folder() const { return folder_ / "run"; }
  bool is_resumable() const { return fs::exists(run_folder() / "checkpoint.h5"); }
  bool has(SweepSource source) const {
    return std::ranges::find(plan_.outputs, source, &SweepOutput::source) != plan_.outputs.end();
  }

  std::vector<std::string> command(const std::string& verb) const;
  ChildEnd start(const std::string& name, const std::vector<std::string>& arguments);
  bool has_ended_early(const ChildEnd& end, const std::string& name, bool has_results);
  bool draw_joints();
  ChildEnd run_or_resume();
  bool run();
  bool find_safety(const SweepOutput& output);
  void add_warnings(const Json& list);
  void take(const SweepOutput& output, const std::function<study::SweptValue()>& find);
  void find_intensities();

  const SweepPlan& plan_;
  const SweepRow& row_;
  const Context& stop_;
  SweepResult result_;
  fs::path folder_;
  std::vector<std::string> drawings_;  ///< made for this job
  bool is_stopped_ = false;
};

std::string text_of_value(const Json& value) {
  return value.is_string() ? value.get<std::string>() : value.dump();
}

std::vector<std::string> SweepJob::command(const std::string& verb) const {
  std::vector<std::string> words{verb};
  words.insert(words.end(), drawings_.begin(), drawings_.end());
  const CaseOptions& given = plan_.given;
  words.insert(words.end(), given.paths.begin(), given.paths.end());
  const auto add = [&](const char* option, const std::string& value) {
    if (!value.empty()) words.insert(words.end(), {option, value});
  };
  add("--profile", given.profile);
  add("--settings-file", given.settings_file);
  add("--layers", given.reading.layers);
  add("--unit", given.reading.choices.unit);
  if (given.reading.choices.join > 0) add("--join", fmt::format("{}", given.reading.choices.join));
  for (const std::string& set : given.sets) add("--set", set);
  for (const std::string& value : given.values) add("--at", value);
  for (const auto& [key, value] : row_.items()) {
    if (value.is_null() || key.starts_with(study::kOfJoints)) continue;
    // JSON keeps a text such as "12" apart from a number.
    const bool is_plain = !value.is_string() || !Json::accept(value.get<std::string>());
    if (key.starts_with('/'))
      add("--at", text_of(ChangedValue{key, is_plain ? text_of_value(value) : value.dump()}));
    else
      add("--set", fmt::format("{}={}", key, text_of_value(value)));
  }
  if (verb != "sif") words.insert(words.end(), {"--threads", "1"});
  return words;
}

ChildEnd SweepJob::start(const std::string& name, const std::vector<std::string>& arguments) {
  const ChildEnd end = run_logged(arguments, plan_.limits, folder_, name, &stop_);
  is_stopped_ = has_been_stopped(end);
  return end;
}

/// Returns true if the process has no answer, and puts the reason into the result.
bool SweepJob::has_ended_early(const ChildEnd& end, const std::string& name, bool has_results) {
  if (is_stopped_) return true;
  const fs::path log = folder_ / (name + ".log");
  std::string why = why_it_ended(end, plan_.limits, log);
  const auto fail = [&](const char* verdict) {
    replace_all(why, folder_.string() + "/", "");
    for (const std::string& path : plan_.given.paths) replace_all(why, path, fs::path(path).filename().string());
    result_.verdict = verdict;
    result_.doubt = why;
    return true;
  };
  if (end.ran_out_of_time) return fail("time_limit");
  if (is_starved(end, plan_.limits)) return fail("memory_limit");
  if (end.signal != 0) {
    why = signal_of(end, plan_.limits);
    return fail("signal");
  }
  const bool is_answer = end.exit_code == int(ExitCode::ok) || end.exit_code == int(ExitCode::check_failed) ||
                         end.exit_code == int(ExitCode::numerical_failure);
  if (is_answer && has_results) return false;
  const std::string error = error_in(log);
  if (!error.empty()) why = error;
  return fail("error");
}

bool SweepJob::draw_joints() {
  if (plan_.joints.empty()) return true;
  drawings_ = {(folder_ / "drawing.geo").string()};
  if (fs::exists(drawings_.front())) return true;  // of the run that goes on
  Json statistics = Json::parse(plan_.joints);
  for (const auto& [key, value] : row_.items()) {
    if (value.is_null() || !key.starts_with(study::kOfJoints)) continue;
    for (const std::string& at : pointers_to(key.substr(study::kOfJoints.size()), statistics.dump(), true))
      statistics[Json::json_pointer(at)] = value;
  }
  write_file(folder_ / "joints.json", statistics.dump(1) + "\n");
  const ChildEnd end =
      start("joints", {"joints", (folder_ / "joints.json").string(), "-o", drawings_.front(), "--force"});
  return !has_ended_early(end, "joints", fs::exists(drawings_.front()));
}

/// A run that was left unfinished goes on, unless its checkpoint does not fit any more.
ChildEnd SweepJob::run_or_resume() {
  if (is_resumable()) {
    const ChildEnd end = start("run", {"run", "--resume", run_folder().string(), "--threads", "1"});
    if (end.exit_code != int(ExitCode::usage) && end.exit_code != int(ExitCode::unreadable)) return end;
    std::error_code error;
    fs::remove_all(run_folder(), error);
  }
  std::vector<std::string> words = command("run");
  words.insert(words.end(), {"-o", run_folder().string(), "--no-pictures", "--contacts", "none"});
  for (const std::string& history : plan_.histories) words.insert(words.end(), {"--history", history});
  return start("run", words);
}

bool SweepJob::run() {
  if (!has(SweepSource::run)) return true;
  const ChildEnd end = run_or_resume();
  const fs::path record = run_folder() / "run.json";
  if (has_ended_early(end, "run", fs::exists(record))) return false;
  const Json told = Json::parse(formats::load(record.string()).text);
  add_warnings(told.at("warnings"));
  const Json& outcome = told.at("outcome");
  result_.verdict = outcome.at("end");
  const Json doubts = outcome.value("doubts", Json::array());
  if (result_.verdict == "failed") result_.doubt = outcome.value("reason", "");
  if (result_.verdict == "finished" && !doubts.empty()) {
    result_.verdict = "doubtful";
    result_.doubt = text_of_value(doubts.front());
  }
  for (const SweepOutput& output : plan_.outputs)
    if (output.source == SweepSource::run) take(output, [&] { return study::value_of_run(output, run_folder()); });
  std::error_code ignored;  // frames of a thousand runs would fill the disk
  fs::remove_all(run_folder() / kFrameFolder, ignored);
  fs::remove(run_folder() / "fields.pvd", ignored);
  return true;
}

bool SweepJob::find_safety(const SweepOutput& output) {
  std::vector<std::string> words = command("fos");
  words.emplace_back("--json");
  words.emplace_back("--no-mesh-error");
  if (!output.reduced.empty()) words.insert(words.end(), {"--reduce", output.reduced});
  if (plan_.within) words.insert(words.end(), {"--to-within", fmt::format("{}", *plan_.within)});
  const ChildEnd end = start(output.name, words);
  const std::string text = formats::load((folder_ / (output.name + ".out")).string()).text;
  if (has_ended_early(end, output.name, Json::accept(text)))  // a refused factor leaves other outputs
    return !is_stopped_ && result_.verdict == "error";
  result_.out[output.name] = study::value_of_fos(text);
  const Json told = Json::parse(text);
  add_warnings(told.value("warnings", Json::array()));
  const std::string how = told.value("end", "bracketed");
  const bool is_good_so_far = result_.verdict.empty() || result_.verdict == "finished";
  if (is_good_so_far && how != "bracketed") {
    result_.verdict = how;
    result_.doubt = study::last_trial_of(text);
  }
  return true;
}

void SweepJob::find_intensities() {
  if (!has(SweepSource::sif)) return;
  std::vector<std::string> words = command("sif");
  words.emplace_back("--json");
  const ChildEnd end = start("sif", words);
  if (has_ended_early(end, "sif", true)) return;
  if (end.exit_code == int(ExitCode::numerical_failure)) {
    result_.verdict = "failed";
    result_.doubt = error_in(folder_ / "sif.log");
    return;
  }
  if (!has(SweepSource::run) && end.exit_code == int(ExitCode::check_failed)) result_.verdict = "doubtful";
  const std::string text = formats::load((folder_ / "sif.out").string()).text;
  add_warnings(Json::parse(text).value("warnings", Json::array()));
  for (const SweepOutput& output : plan_.outputs)
    if (output.source == SweepSource::sif) take(output, [&] { return study::value_of_sif(output, text); });
}

/// Adds the codes of warnings that the row does not have yet. Notes stay in the records of the job.
void SweepJob::add_warnings(const Json& list) {
  for (const Json& warning : list) {
    const std::string code = warning.at("name");
    const bool is_known = fmt::format(" {} ", result_.warnings).find(fmt::format(" {} ", code)) != std::string::npos;
    if (is_known || level_of(code) != DiagnosticLevel::warning) continue;
    result_.warnings += (result_.warnings.empty() ? "" : " ") + code;
  }
}

/// Puts an output into the result. One that the results lack is the reason of the row.
void SweepJob::take(const SweepOutput& output, const std::function<study::SweptValue()>& find) {
  try {
    const study::SweptValue found = find();
    result_.out[output.name] = found.value;
    if (!found.unit.empty()) result_.units[output.name] = found.unit;
  } catch (const study::OutputLacking& lacking) {
    result_.lacking[output.name] = lacking.what();
    if (result_.verdict != "finished" && result_.verdict != "doubtful") return;
    result_.verdict = "error";
    result_.doubt = lacking.what();
  }
}

}  // namespace

std::optional<SweepResult> do_sweep_job(const SweepPlan& plan, const SweepRow& row, const Context& stop) {
  return SweepJob(plan, row, stop).done();
}

}  // namespace keyblock
