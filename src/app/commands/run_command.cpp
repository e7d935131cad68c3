// `keyblock run`: runs a case and writes its results into a folder.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>

#include "api/plan.hpp"
#include "app/command.hpp"
#include "app/commands/both_profiles.hpp"
#include "app/input/case_options.hpp"
#include "app/messages.hpp"
#include "app/option_checks.hpp"
#include "app/output_options.hpp"
#include "app/progress.hpp"
#include "app/run_words/run_messages.hpp"
#include "app/stop_request.hpp"
#include "app/strength/strength_reduction.hpp"
#include "base/bytes/sha256.hpp"
#include "base/context.hpp"
#include "base/error.hpp"
#include "job/run_heading.hpp"
#include "job/run_job.hpp"
#include "run/follow/history_option.hpp"
#include "run/look_ahead.hpp"
#include "run/settings_of.hpp"
#include "settings/profile.hpp"
#include "settings/settings_guide.hpp"
#include "settings/settings_table.hpp"

namespace keyblock {
namespace {

// What an interruption may cost, unless asked otherwise.
constexpr double kCheckpointSeconds = 30;

struct RunOptions {
  CaseOptions given;
  std::string folder;
  std::string resume;  ///< folder of a run to go on with
  double checkpoint_every = kCheckpointSeconds;
  int record_every = 0;
  bool as_json = false;
  bool trace = false;
  bool force = false;
  bool both = false;  ///< profiles, one after the other
  bool list_settings = false;
  OutputOptions outputs;
  ReductionOptions reduction;
};

class Stopwatch {
 public:
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - last_).count();
    last_ = now;
    return seconds;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

std::vector<InputRecord> input_records(const std::vector<formats::FileReading>& readings) {
  std::vector<InputRecord> records;
  for (const formats::FileReading& file : readings)
    records.push_back({file.path, sha256(file.source.text), std::string(file.choice->format->name),
                       file.choice->recognition.evidence});
  return records;
}

ExitCode exit_code(const RunRecord& record) {
  switch (record.outcome.end) {
    case RunEnd::finished:
      return record.doubts.empty() ? ExitCode::ok : ExitCode::check_failed;
    case RunEnd::failed:
      return ExitCode::numerical_failure;
    case RunEnd::stopped:
      return is_at_time_limit() ? ExitCode::limit : ExitCode::stopped;
  }
  return ExitCode::numerical_failure;
}

ExitCode list_settings(const RunOptions& options) {
  fmt::print("{}", options.as_json ? settings_json() : settings_guide());
  return ExitCode::ok;
}

RunRequest request_of(const RunOptions& options, const std::vector<std::string>& files,
                      const std::vector<Override>& overrides, const RunRecord& record, const Settings& settings) {
  RunRequest request{this_program(),
                     std::filesystem::weakly_canonical(std::filesystem::absolute(options.folder)).string(),
                     (context().folder().empty() ? std::filesystem::current_path() : context().folder()).string(),
                     files,
                     record.profile,
                     {},
                     record.record_every,
                     options.trace,
                     {},
                     {},
                     {},
                     options.outputs.histories,
                     options.outputs.contacts,
                     options.outputs.field,
                     options.given.reading.choices.unit,
                     options.given.reading.choices.join,
                     options.outputs.frames,
                     options.outputs.has_pictures};
  for (const auto& [name, value] : overrides) request.sets.push_back(fmt::format("{}={}", name, value));
  for (const InputRecord& input : record.inputs) {
    request.read.push_back(input.file);
    request.digests.push_back(input.sha256);
  }
  if (const std::string& named = settings.body_acceleration.file; !named.empty()) {
    request.read.push_back(named);
    request.digests.push_back(sha256(formats::load(named).text));
  }
  for (const SettingText& setting : list(settings)) request.settings.push_back(setting.name + "=" + setting.value);
  return request;
}

ProfileAnswer answer_of(const RunRecord& record, const Prepared& prepared, const std::string& folder) {
  double modulus = 0;
  for (const BlockMaterial& rock : prepared.scene.model.block_materials)
    modulus = std::max(modulus, rock.youngs_modulus);
  return {record.profile,
          folder,
          {},
          exit_code(record),
          record,
          prepared.scene.settings,
          prepared.scene.model.elements.size(),
          prepared.scene.model.scale,
          modulus};
}

// `saved`: the checkpoint to go on from, its request already taken, or all that a run left before its first one; none
// for a new run.
ProfileAnswer run_asked(const RunOptions& options, RunMessages& messages, const RunRequest* saved_request,
                        Archive* saved) {
  Stopwatch watch;
  const OpenCase asked = opened(case_of(options.given));
  const formats::Case& loaded = asked.input;
  Problem problem_asked = loaded.problem;
  RunRecord record;
  record.units = loaded.problem.units;
  record.inputs = input_records(loaded.files);
  record.timings.read = watch.lap();
  problem_asked.outputs = outputs_asked(problem_asked.outputs, options.outputs);
  const PlannedCase plan = planned(asked, problem_asked);
  const Prepared& prepared = plan.prepared;
  const Problem& problem = plan.problem;
  record.profile = plan.profile.name;
  record.profile_because = plan.profile.why;
  record.record_every =
      options.record_every > 0 ? options.record_every : usual_frame_interval(problem, prepared.scene.settings);
  record.warnings = joined(loaded.warnings, plan.warnings);
  record.timings.prepare = watch.lap();
  const std::string title = title_of(asked.files.front(), record.profile);
  RunRequest request = request_of(options, asked.files, plan.asked, record, prepared.scene.settings);
  if (saved) require_same(checkpoint_in(options.folder), *saved_request, request);
  for (const std::string& file : asked.files) require_not_below(file, options.folder);
  RunJob job(
      prepared, std::move(record), std::move(request),
      {options.folder, overwrite_if(options.force), options.trace ? Trace::yes : Trace::no, options.checkpoint_every,
       problem.analysis->place, problem.outputs, options.outputs.field, formats::names_of(loaded.files),
       formats::vtk_coding_of(options.outputs.frames), options.outputs.has_pictures},
      saved);
  listen_for_stops();  // from here on something is left that a stop should leave whole
  job.open();
  ProgressLine progress(prepared.scene.settings.step_count, job.steps_before().value_or(0), softer_springs(prepared),
                        job.record().units);
  messages.print_start(asked.files.front(), prepared, job.record());
  if (saved != nullptr) messages.print_resumed(job.steps_before());
  if (!job.run([&](const StepReport& report) { progress.show(report); })) {
    messages.print_stopped_early(options.folder);
    return answer_of(job.record(), prepared, options.folder);
  }
  progress.finish();
  const std::string json = job.finish(title, watch.lap());
  if (options.as_json && !options.both) print_record(json, options.folder + "/run.json");
  messages.print_end(prepared, job.record(), options.folder);
  return answer_of(job.record(), prepared, options.folder);
}

// Asks again what the run was asked, from the folder that names of its files were taken from.
ExitCode resume_run(const RunOptions& options) {
  RunOptions again = options;
  again.folder = std::filesystem::absolute(options.resume).string();
  Archive saved = read_checkpoint(checkpoint_in(again.folder));
  RunRequest request;
  saved.group("request", [&] { describe(saved, request); });
  require_own(checkpoint_in(again.folder), request);
  if (!std::filesystem::is_directory(request.working_folder))
    saved.refuse("working_folder", fmt::format("expected the folder {}, found none", request.working_folder));
  context().use_folder(request.working_folder);
  if (request.record_every < 1 || request.files.empty())
    saved.refuse("request", "expected files and a frame every so many steps, found none");
  again.given = {request.files, request.profile, request.sets, {}, {}};
  again.record_every = request.record_every;
  again.trace = request.has_trace;
  again.outputs.histories = request.histories;
  again.outputs.contacts = request.contacts;
  again.outputs.field = request.field;
  again.outputs.frames = request.frames;
  again.outputs.has_pictures = request.has_pictures;
  again.given.reading.choices = {request.unit, request.join};
  RunMessages messages;
  return run_asked(again, messages, &request, &saved).code;
}

ExitCode run_reduced(const RunOptions& options) {
  ReductionOptions reduction = options.reduction;
  reduction.folder = options.folder;
  reduction.as_json = options.as_json;
  reduction.force = options.force;
  return reduce_strength(case_of(options.given), reduction);
}

// One profile that cannot be run is told beside the answer of the other.
ProfileAnswer answer_under(const RunOptions& options, const std::string& profile, RunMessages& messages) {
  RunOptions own = options;
  own.given.profile = profile;
  own.folder = (std::filesystem::path(options.folder) / profile).string();
  const auto refused = [&](const std::exception& error) {
    ProfileAnswer answer;
    answer.profile = profile;
    answer.folder = "-";
    answer.refused = error.what();
    answer.code = ExitCode::unreadable;
    spdlog::error("{}", error.what());
    return answer;
  };
  try {
    return run_asked(own, messages, nullptr, nullptr);
  } catch (const InputError& error) {
    return refused(error);
  } catch (const UsageError& error) {
    return refused(error);
  } catch (const std::invalid_argument& error) {
    return refused(error);
  }
}

// Under the rules of the old programs and under those of today; first those that the files ask for.
ExitCode run_both(const RunOptions& options) {
  const OpenCase asked = opened(case_of(options.given));
  const bool is_old = rules_of(profile_of(asked.input.problem, {}, asked.common)) == "legacy";
  RunMessages messages;
  std::vector<ProfileAnswer> answers;
  for (const char* profile : {is_old ? "legacy" : "standard", is_old ? "standard" : "legacy"}) {
    answers.push_back(answer_under(options, profile, messages));
    if (answers.back().record.outcome.end == RunEnd::stopped) return answers.back().code;
  }
  if (!answers[0].refused.empty() && !answers[1].refused.empty()) return answers[0].code;
  if (options.as_json)
    print_record(
        side_by_side_json(answers[0], answers[1]).dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace),
        "the folders of both runs");
  else
    fmt::print("{}", side_by_side(answers[0], answers[1], asked.input.problem.units));
  return code_of_both(answers[0], answers[1]);
}

ExitCode run_files(const RunOptions& options) {
  if (options.list_settings) return list_settings(options);
  if (!options.resume.empty()) return resume_run(options);
  if (options.given.paths.empty()) throw UsageError("run: no input given; usage: keyblock run CASE -o FOLDER");
  if (!options.reduction.what.empty()) return run_reduced(options);
  if (options.folder.empty())
    throw UsageError("run: no folder given for the results; usage: keyblock run CASE -o FOLDER");
  if (options.both) return run_both(options);
  RunMessages messages;
  return run_asked(options, messages, nullptr, nullptr).code;
}

}  // namespace

Action configure_run(CLI::App& options) {
  const auto chosen = std::make_shared<RunOptions>();
  const auto [files, profile, sets, settings_file, reading] = add_case_options(
      options, chosen->given, "a case file, a geometry (or block) file with its analysis file, or a case folder");
  CLI::Option* folder =
      options
          .add_option("-o,--output", chosen->folder,
                      "folder for the results (not needed with --resume, --reduce-strength and --settings)")
          ->type_name("FOLDER");
  CLI::Option* every =
      options
          .add_option(
              "--record-every", chosen->record_every,
              fmt::format("steps per frame (default: the save interval of the file, at most {} frames)", kMostFrames))
          ->check(above_zero());
  CLI::Option* trace =
      options.add_flag("--trace", chosen->trace, "also write steps.csv (every step) and blocks.csv (every frame)");
  const auto [histories, contacts, field, frames, pictures] = add_output_options(options, chosen->outputs);
  CLI::Option* both = options.add_flag(
      "--both", chosen->both,
      "run the profiles legacy and standard into FOLDER/legacy and FOLDER/standard; print results, differences and "
      "known causes side by side");
  options.add_flag("--json", chosen->as_json,
                   "print run.json on standard output; with --both or --settings, their table as JSON");
  CLI::Option* force = options.add_flag("--force", chosen->force, "overwrite the results of an earlier run");
  options
      .add_option("--checkpoint-every", chosen->checkpoint_every,
                  "seconds between checkpoints (default: 30; the first after at most 3); 0: only at the start and if "
                  "the run is stopped")
      ->check(zero_or_above());
  CLI::Option* resume =
      options
          .add_option("--resume", chosen->resume,
                      "continue the interrupted run in FOLDER from its checkpoint, or from the start without one")
          ->type_name("FOLDER");
  CLI::Option* reduced =
      options.add_option("--reduce-strength", chosen->reduction.what, "same as `keyblock fos --reduce`")
          ->check(one_word_of({"joints", "rock", "both"}));
  for (CLI::Option* of_search : add_reduction_options(options, chosen->reduction)) of_search->needs(reduced);
  for (CLI::Option* of_run : {every, trace, both, histories, contacts, field, frames, pictures})
    reduced->excludes(of_run);
  both->excludes(profile);
  for (CLI::Option* other : {files, profile, folder, sets, settings_file, every, trace, force, reduced, both, histories,
                             contacts, field, frames, pictures})
    resume->excludes(other);
  for (CLI::Option* of_drawing : reading) resume->excludes(of_drawing);
  add_thread_option(options);
  options.add_flag("--settings", chosen->list_settings, "list the settings that --set accepts, and exit");
  return [chosen] { return run_files(*chosen); };
}

}  // namespace keyblock
