// `keyblock run`: runs a case and writes its results into a folder.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
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
#include "base/error.hpp"
#include "job/recorded_run.hpp"
#include "run/look_ahead.hpp"
#include "settings/profile.hpp"
#include "settings/settings_guide.hpp"
#include "settings/settings_table.hpp"

namespace keyblock {
namespace {

constexpr const char* kUsualFolder = "out";  ///< folder for the results of a run without -o

struct RunOptions {
  CaseOptions given;
  std::string folder;
  std::string resume;                      ///< folder of a run to resume
  std::optional<double> checkpoint_every;  ///< seconds; nothing: as in RecordingOptions, or as the run began
  int record_every = 0;
  bool as_json = false;
  bool trace = false;
  bool force = false;
  bool both = false;  ///< profiles, in sequence
  bool list_settings = false;
  std::string stop_when;
  OutputOptions outputs;
  ReductionOptions reduction;
};

ExitCode exit_code(const RunRecord& record) {
  switch (record.outcome.end) {
    case RunEnd::finished:
      return record.doubts.empty() ? ExitCode::ok : ExitCode::check_failed;
    case RunEnd::failed:
      return ExitCode::numerical_failure;
    case RunEnd::stopped:
      if (!record.outcome.why_early.empty()) return ExitCode::ok;  // at the criterion of --stop-when
      return is_at_time_limit() ? ExitCode::limit : ExitCode::stopped;
  }
  return ExitCode::numerical_failure;
}

ExitCode list_settings(const RunOptions& options) {
  fmt::print("{}", options.as_json ? settings_json() : settings_guide());
  return ExitCode::ok;
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

RecordingOptions recording_of(const RunOptions& options) {
  return {options.folder,
          overwrite_if(options.force),
          options.trace ? Trace::yes : Trace::no,
          options.checkpoint_every.value_or(RecordingOptions{}.checkpoint_every),
          options.record_every,
          options.outputs,
          options.stop_when};
}

ProfileAnswer answer_of_run(RecordedRun& run, RunMessages& messages, bool is_resumed, bool prints_json) {
  listen_for_stops();  // from here on a stop must leave complete files
  run.open();
  const Prepared& prepared = run.prepared();
  ProgressLine progress(prepared.scene.settings.step_count, run.steps_before().value_or(0), softer_springs(prepared),
                        run.record().units);
  messages.print_start(run.first_file(), prepared, run.record());
  if (is_resumed) messages.print_resumed(run.steps_before());
  if (!run.run([&](const StepReport& report) { progress.show(report); })) {
    messages.print_stopped_early(run.folder());
    return answer_of(run.record(), prepared, run.folder());
  }
  progress.finish();
  const std::string json = run.finish();
  if (prints_json) print_record(json, run.folder() + "/run.json");
  messages.print_end(prepared, run.record(), run.folder());
  return answer_of(run.record(), prepared, run.folder());
}

ProfileAnswer run_asked(const RunOptions& options, RunMessages& messages) {
  RecordedRun run(case_of(options.given), recording_of(options));
  return answer_of_run(run, messages, false, options.as_json && !options.both);
}

ExitCode resume_run(const RunOptions& options) {
  RecordedRun run(options.resume, options.checkpoint_every);
  RunMessages messages;
  return answer_of_run(run, messages, true, options.as_json).code;
}

ExitCode run_reduced(const RunOptions& options) {
  ReductionOptions reduction = options.reduction;
  reduction.folder = options.folder;
  reduction.as_json = options.as_json;
  reduction.force = options.force;
  return reduce_strength(case_of(options.given), reduction);
}

// A profile that cannot be run is reported together with the result of the other.
ProfileAnswer answer_under(const RunOptions& options, const std::string& profile, RunMessages& messages) {
  RunOptions own = options;
  own.given.profile = profile;
  own.folder = (std::filesystem::path(options.folder) / profile).string();
  const auto refused = [&](const std::exception& error, ExitCode code) {
    ProfileAnswer answer;
    answer.profile = profile;
    answer.folder = "-";
    answer.refused = error.what();
    answer.code = code;
    spdlog::error("{}", error.what());
    return answer;
  };
  try {
    return run_asked(own, messages);
  } catch (const InputError& error) {
    return refused(error, ExitCode::unreadable);
  } catch (const UsageError& error) {
    return refused(error, ExitCode::usage);
  } catch (const std::invalid_argument& error) {
    return refused(error, ExitCode::usage);
  }
}

// Runs under the rules of Shi's programs and under the standard ones; first under those that the files request.
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
  if (options.given.paths.empty()) throw UsageError("run: no input given; usage: keyblock run CASE [-o FOLDER]");
  if (!options.reduction.what.empty()) return run_reduced(options);
  RunOptions into = options;
  if (into.folder.empty()) into.folder = kUsualFolder;
  if (into.both) return run_both(into);
  RunMessages messages;
  return run_asked(into, messages).code;
}

}  // namespace

Action configure_run(CLI::App& options) {
  const auto chosen = std::make_shared<RunOptions>();
  const auto [files, profile, sets, values, settings_file, reading] = add_case_options(
      options, chosen->given,
      "a case file (NAME for NAME.json), a geometry (or block) file with its analysis file, or a case folder");
  CLI::Option* folder =
      options
          .add_option("-o,--output", chosen->folder,
                      fmt::format("folder for the results (default: {}; with --reduce-strength none)", kUsualFolder))
          ->type_name("FOLDER");
  CLI::Option* every =
      options
          .add_option(
              "--record-every", chosen->record_every,
              fmt::format("steps per frame (default: the save interval of the file, at most {} frames)", kMostFrames))
          ->check(above_zero());
  CLI::Option* trace =
      options.add_flag("--trace", chosen->trace, "also write steps.csv (every step) and blocks.csv (every frame)");
  const auto [histories, contacts, field, frames, pictures, page] = add_output_options(options, chosen->outputs);
  CLI::Option* both = options.add_flag(
      "--both", chosen->both,
      "run the profiles legacy and standard into FOLDER/legacy and FOLDER/standard; print results, differences and "
      "known causes side by side");
  options.add_flag("--json", chosen->as_json,
                   "print run.json on standard output; with --both or --settings, their table as JSON");
  CLI::Option* force = options.add_flag("--force", chosen->force, "overwrite the results of an earlier run");
  options
      .add_option("--checkpoint-every", chosen->checkpoint_every,
                  "seconds between checkpoints (default: 30, with --resume as before; the first after at most 3); 0: "
                  "only at the start and if the run is stopped")
      ->check(zero_or_above());
  CLI::Option* stop_when =
      options
          .add_option("--stop-when", chosen->stop_when,
                      "stop behind the step in which a quantity of a history passes a limit: crest.dx>0.05, "
                      "crest.d>5 cm; --resume continues")
          ->type_name("NAME.QUANTITY>VALUE");
  stop_when->excludes(both);
  CLI::Option* resume =
      options
          .add_option("--resume", chosen->resume,
                      "continue the interrupted run in FOLDER from its checkpoint, or from the start without one")
          ->type_name("FOLDER");
  CLI::Option* reduced =
      options.add_option("--reduce-strength", chosen->reduction.what, "same as `keyblock fos --reduce`")
          ->check(one_word_of({"joints", "rock", "both"}));
  for (CLI::Option* of_search : add_reduction_options(options, chosen->reduction)) of_search->needs(reduced);
  for (CLI::Option* of_run : {every, trace, both, histories, contacts, field, frames, pictures, page, stop_when})
    reduced->excludes(of_run);
  both->excludes(profile);
  for (CLI::Option* other : {files, profile, folder, sets, values, settings_file, every, trace, force, reduced, both,
                             histories, contacts, field, frames, pictures, page, stop_when})
    resume->excludes(other);
  for (CLI::Option* of_drawing : reading) resume->excludes(of_drawing);
  add_thread_option(options);
  options.add_flag("--settings", chosen->list_settings, "list the settings that --set accepts, and exit");
  return [chosen] { return run_files(*chosen); };
}

}  // namespace keyblock
