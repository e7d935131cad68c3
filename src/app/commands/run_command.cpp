// `keyblock run`: a case from its files to results in a folder.
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
#include "app/stop_request.hpp"
#include "app/strength/strength_reduction.hpp"
#include "base/bytes/sha256.hpp"
#include "base/context.hpp"
#include "base/error.hpp"
#include "cut/bodies/slivers.hpp"
#include "geometry/box.hpp"
#include "geometry/polygon.hpp"
#include "job/run_heading.hpp"
#include "job/run_job.hpp"
#include "run/ahead/plausible_units.hpp"
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

// Statics says nothing of a scene from which a sliver falls.
void print_sliver_hint(const Prepared& prepared, const RunOutcome& outcome) {
  const std::vector<BlockPolygon>& blocks = prepared.blocks.blocks;
  if (!is_of_the_scene(outcome.failure) || outcome.numbers.empty() || !outcome.scenes.empty()) return;
  const double mean = prepared.scene.model.mean_area;
  const bool are_slivers = std::ranges::all_of(outcome.numbers, [&](int number) {
    const auto at = static_cast<std::size_t>(number) - 1;
    return at < blocks.size() && is_sliver(form_of(blocks[at]), mean);
  });
  if (!are_slivers) return;
  const bool is_one = outcome.numbers.size() == 1;
  spdlog::info(
      "block{} {} {}, {}, and nothing else was found to move: {} no equilibrium of the others; --set slivers=glue "
      "joins such blocks to their neighbours, --set slivers=leave_out takes them away, and `keyblock fos` leaves them "
      "out by "
      "itself",
      is_one ? "" : "s", fmt::join(outcome.numbers, ", "), is_one ? "is a sliver" : "are slivers", slivers_in_words(),
      is_one ? "it hides" : "they hide");
}

// What to try where a run failed.
void print_hint(const Prepared& prepared, const RunOutcome& outcome) {
  const std::vector<Remedy> remedies = what_to_try(prepared, outcome);
  if (remedies.empty()) return;
  if (prepared.scene.settings.dynamics == Dynamics::shi)
    spdlog::info(
        "the rules of the old program are followed, as far as they are known from its traces (docs/old_slopes.md says "
        "what is shown)");
  std::vector<std::string> options, what;
  for (const Remedy& remedy : remedies) {
    options.push_back(remedy.option);
    what.push_back(remedy.what);
  }
  spdlog::info("to try: {} ({})", fmt::join(options, ", or "), fmt::join(what, ", "));
  if (outcome.failure == FailureKind::accelerates && prepared.scene.growth == nullptr)
    spdlog::info("the scene may be unstable as it is: keyblock fos finds by which factor its strength is too small");
}

// What the steps cost, and how evenly.
std::string passes_in_words(const Settings& settings, const StepTotals& totals) {
  std::string words = fmt::format("{} a step: {:.3g} in the mean, {} at most",
                                  settings.dynamics == Dynamics::shi ? "passes" : "systems",
                                  static_cast<double>(totals.passes) / totals.steps, totals.most_passes);
  for (std::size_t i = 0; i < totals.steps_by_passes.size(); ++i) {
    if (totals.steps_by_passes[i] == 0) continue;
    const bool is_last = i == StepTotals::pass_limits.size();
    const std::string bin =
        i == 0    ? "0"
        : is_last ? fmt::format("over {}", StepTotals::pass_limits.back())
                  : fmt::format("{} to {}", StepTotals::pass_limits[i - 1] + 1, StepTotals::pass_limits[i]);
    words += fmt::format("; {} in {}", bin, counted(static_cast<std::size_t>(totals.steps_by_passes[i]), "step"));
  }
  return words;
}

std::string stopped_how() {
  return is_at_time_limit() ? "stopped at the limit of processor time" : "stopped by request";
}

std::string how_to_go_on(const std::string& folder) {
  return fmt::format("keyblock run --resume {} goes on", folder);
}

void print_stages(const std::vector<SceneReport>& stages) {
  for (std::size_t i = 0; i < stages.size(); ++i) {
    const SceneReport& stage = stages[i];
    if (stage.last_step == stage.first_step) continue;  // stopped before its first step
    spdlog::info("stage {}{}: steps {} to {}, time {:.6g}{}", i + 1,
                 stage.name.empty() ? "" : fmt::format(" ({})", stage.name), stage.first_step + 1, stage.last_step,
                 stage.end_time, stage.is_balanced ? ", balanced" : "");
  }
}

// How much rock has yielded, and reactions that stand or still grow.
void print_yielding(const RunRecord& record) {
  if (record.plastic && record.plastic->totals.yielded == 0)
    spdlog::info("no rock has yielded");
  else if (record.plastic)
    spdlog::info("yielded: {:.3g} % of the rock that may; equivalent plastic strain up to {:.3g}, in element {}",
                 100 * record.plastic->totals.yielded_fraction(), record.plastic->equivalent,
                 record.plastic->element + 1);
  const bool yields = record.plastic && record.plastic->totals.yielded > 0;
  for (const ReactionCurve& curve : record.reactions) {
    if (const std::optional<std::size_t> first = plateau_of(curve))
      spdlog::info(
          "limit load of this mesh: reaction {} of displacement {} stands at {:.6g} since step {}, driven by {:.4g}",
          curve.component, curve.number + 1, curve.reaction.back(), curve.steps[*first], curve.driven[*first]);
    else if (const std::optional<double> slope = end_slope(curve); slope && yields)
      spdlog::info(
          "stopped at {:.6g}, reaction {} of displacement {}, driven by {:.4g}: no limit load, for the reaction {} by "
          "{:.2g} % for each % that it is driven further",
          curve.reaction.back(), curve.component, curve.number + 1, curve.driven.back(), *slope < 0 ? "falls" : "grows",
          std::abs(*slope));
  }
}

// Of what stress across the bodies would push with: resultants of loads that cancel are less.
constexpr double kNoResultant = 1e-6;

/// Force that the greatest stress at the end has over the length of the bodies.
double force_of_stress(const FieldFrame& field) {
  Box box;
  double greatest = 0;
  for (const FieldElement& element : field.elements)
    for (const std::vector<FieldCorner>& loop : element.loops)
      for (const FieldCorner& corner : loop) {
        box.add(corner.position);
        greatest =
            std::max({greatest, std::abs(corner.stress.xx), std::abs(corner.stress.yy), std::abs(corner.stress.xy)});
      }
  return field.elements.empty() ? 0 : greatest * length(box.size());
}

void print_balance(const ForceBalance& forces, const FieldFrame& field) {
  if (length(forces.loads.force) == 0 && forces.loads.moment == 0) return spdlog::info("no loads act");
  double largest = length(forces.loads.force);
  for (const Resultant& support : forces.supports) largest = std::max(largest, length(support.force));
  if (largest <= kNoResultant * force_of_stress(field))
    spdlog::info("loads are in equilibrium by themselves");
  else
    spdlog::info("loads and supports balance to {:.1e} of the largest", forces.unbalanced());
}

/// `told`: how many of the warnings were printed at the start.
void print_summary(const Prepared& prepared, const RunRecord& record, std::size_t told, const std::string& folder) {
  log_by_level({record.warnings.begin() + static_cast<std::ptrdiff_t>(told), record.warnings.end()}, "the run");
  if (record.outcome.end == RunEnd::failed) {
    spdlog::error("keyblock: error: {}", record.outcome.reason);
    print_sliver_hint(prepared, record.outcome);
    print_hint(prepared, record.outcome);
  }
  if (record.outcome.end == RunEnd::stopped) spdlog::warn("{}; {}", stopped_how(), how_to_go_on(folder));
  if (record.outcome.end == RunEnd::finished && record.equilibrium_way && record.equilibrium_way->share)
    spdlog::info("static: {:.3g} % of the way to equilibrium", 100 * *record.equilibrium_way->share);
  if (!record.outcome.start.balanced.empty()) spdlog::info("start: {}", record.outcome.start.balanced);
  print_stages(record.outcome.scenes);
  if (record.outcome.forces) print_balance(*record.outcome.forces, record.outcome.field);
  print_yielding(record);
  if (record.totals.steps > 0) spdlog::info("{}", passes_in_words(prepared.scene.settings, record.totals));
  if (!record.outcome.why_early.empty())
    spdlog::info("ended before step {}: {}", record.outcome.steps + 1, record.outcome.why_early);
  if (record.motion)
    for (const std::string& sentence : sentences(prepared, record, *record.motion)) spdlog::info("{}", sentence);
  spdlog::info("{}, time {:.6g}{}{}; results in {}", counted(record.outcome.steps, "step"), record.outcome.time,
               record.units.time.empty() ? "" : " ", record.units.time, folder);
  if (record.outcome.end == RunEnd::finished && !record.doubts.empty())
    spdlog::error("keyblock: error: the results are not to be trusted: {}", record.doubts.front().sentence);
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

// What will be computed, and what is to be said of it before.
void print_start(const Prepared& prepared, const RunJob& job, bool is_resumed) {
  const Model& model = prepared.scene.model;
  const RunRecord& record = job.record();
  spdlog::info(
      "profile {}, because {}{}", record.profile, record.profile_because,
      record.profile == "legacy" ? " (--profile standard: the rules of today; --both: both, side by side)" : "");
  if (const std::string size = size_of_scene(model, record.units); !size.empty()) spdlog::info("{}", size);
  spdlog::info("{}, {} unknowns, {} steps", counted(model.elements.size(), model.nodes.empty() ? "block" : "element"),
               prepared.requirements.unknowns, prepared.scene.settings.step_count);
  log_by_level(record.warnings, "the case");
  spdlog::debug("read in {:.3g} s, prepared in {:.3g} s; a frame every {}", record.timings.read, record.timings.prepare,
                counted(static_cast<std::size_t>(record.record_every), "step"));
  if (const std::optional<int> step = job.steps_before())
    spdlog::info("going on after step {}", *step);
  else if (is_resumed)
    spdlog::info("the run ended before its first checkpoint: it begins again");
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
ProfileAnswer run_asked(const RunOptions& options, const RunRequest* saved_request, Archive* saved) {
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
  const std::size_t told = job.record().warnings.size();
  job.open();
  ProgressLine progress(prepared.scene.settings.step_count, job.steps_before().value_or(0), softer_springs(prepared));
  print_start(prepared, job, saved != nullptr);
  if (!job.run([&](const StepReport& report) { progress.show(report); })) {
    spdlog::warn("{} before the first step; {}", stopped_how(), how_to_go_on(options.folder));
    return answer_of(job.record(), prepared, options.folder);
  }
  progress.finish();
  const std::string json = job.finish(title, watch.lap());
  if (options.as_json && !options.both) print_record(json, options.folder + "/run.json");
  print_summary(prepared, job.record(), told, options.folder);
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
  return run_asked(again, &request, &saved).code;
}

ExitCode run_reduced(const RunOptions& options) {
  ReductionOptions reduction = options.reduction;
  reduction.folder = options.folder;
  reduction.as_json = options.as_json;
  reduction.force = options.force;
  return reduce_strength(case_of(options.given), reduction);
}

// One profile that cannot be run is told beside the answer of the other.
ProfileAnswer answer_under(const RunOptions& options, const std::string& profile) {
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
    return run_asked(own, nullptr, nullptr);
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
  std::vector<ProfileAnswer> answers;
  for (const char* profile : {is_old ? "legacy" : "standard", is_old ? "standard" : "legacy"}) {
    answers.push_back(answer_under(options, profile));
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
  if (options.given.paths.empty()) throw UsageError("run: expected a geometry and an analysis file, or a case folder");
  if (!options.reduction.what.empty()) return run_reduced(options);
  if (options.folder.empty()) throw UsageError("run: expected -o FOLDER for the results");
  if (options.both) return run_both(options);
  return run_asked(options, nullptr, nullptr).code;
}

}  // namespace

Action configure_run(CLI::App& options) {
  const auto chosen = std::make_shared<RunOptions>();
  const auto [files, profile, sets, settings_file, reading] =
      add_case_options(options, chosen->given,
                       "geometry (or blocks) and analysis file, one file with both, or a case folder (legacy_cases/…) "
                       "with its own settings");
  CLI::Option* folder =
      options
          .add_option("-o,--output", chosen->folder,
                      "folder for the results (required, but not with --resume, --reduce-strength and --settings)")
          ->type_name("FOLDER");
  CLI::Option* every =
      options
          .add_option("--record-every", chosen->record_every,
                      fmt::format("a frame every so many steps (default: the file's save interval, at most {} frames)",
                                  kMostFrames))
          ->check(above_zero());
  CLI::Option* trace =
      options.add_flag("--trace", chosen->trace, "also write steps.csv (every step) and blocks.csv (every frame)");
  const auto [histories, contacts, field, frames, pictures] = add_output_options(options, chosen->outputs);
  CLI::Option* both = options.add_flag(
      "--both", chosen->both,
      "run the profiles legacy and standard, into FOLDER/legacy and FOLDER/standard, and print their answers side by "
      "side, what differs, and why as far as it is known");
  options.add_flag("--json", chosen->as_json,
                   "print run.json on standard output; with --both, both answers; with --settings, those");
  CLI::Option* force = options.add_flag("--force", chosen->force, "overwrite the results of an earlier run");
  options
      .add_option("--checkpoint-every", chosen->checkpoint_every,
                  "seconds between checkpoints in the folder (default: 30; the first after 3 at most); 0: none but at "
                  "the start and where the run is stopped")
      ->check(zero_or_above());
  CLI::Option* resume =
      options
          .add_option(
              "--resume", chosen->resume,
              "folder of an interrupted run, which goes on from its checkpoint, or begins again before its first")
          ->type_name("FOLDER");
  CLI::Option* reduced =
      options
          .add_option("--reduce-strength", chosen->reduction.what,
                      "joints, rock or both: divide their strength until the case no longer stands, as `fos` does")
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
  options.add_flag("--settings", chosen->list_settings, "list the settings that --set takes, and stop");
  return [chosen] { return run_files(*chosen); };
}

}  // namespace keyblock
