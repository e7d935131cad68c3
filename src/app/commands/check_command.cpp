// `keyblock check`: prints format, contents, warnings and errors of input files, and the estimated run time.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "api/case_folder.hpp"
#include "api/plan.hpp"
#include "app/command.hpp"
#include "app/input/case_options.hpp"
#include "app/messages.hpp"
#include "app/option_checks.hpp"
#include "app/progress.hpp"
#include "base/counted.hpp"
#include "base/decimals.hpp"
#include "base/printable.hpp"
#include "base/sentences/sentences.hpp"
#include "cut/covers/from_cover.hpp"
#include "formats/case.hpp"
#include "job/run_heading.hpp"
#include "job/run_report.hpp"
#include "problem/checks/check.hpp"
#include "run/ahead/plausible_units.hpp"
#include "run/follow/drawn_joints.hpp"
#include "run/follow/followed.hpp"
#include "run/follow/history_option.hpp"
#include "run/look_ahead.hpp"
#include "run/prepare.hpp"
#include "run/trial_steps.hpp"

namespace keyblock {
namespace {

using Json = nlohmann::ordered_json;

// Default time for trying steps.
constexpr double kTrialSeconds = 2;
constexpr int kTrialSteps = 20;
constexpr double kSeconds = 10;  // shorter times are printed with two digits

struct CheckOptions {
  CaseOptions given;
  bool as_json = false;
  double trial_seconds = kTrialSeconds;
};

/// Report on the whole case: its warnings, or the reason why it could not be assembled.
struct CaseReport {
  Warnings warnings;
  std::vector<std::string> errors;
  std::optional<Requirements> plan;      ///< features of a run; only if there are geometry and analysis
  std::vector<std::string> stages = {};  ///< one sentence each
  ChosenProfile profile = {};            ///< of the plan
  std::string smallest_block = {};
  std::string size = {};  ///< of the scene
  std::optional<TrialSteps> trial = {};
  int steps = 0;       ///< requested
  Json settings = {};  ///< of the plan
  Units units = {};
  std::string lacks = {};  ///< "geometry" or "analysis" if the files have only the other; empty otherwise
};

Json counts_of(const Drawing& drawing) {
  return {{"lines", drawing.joints.size()},
          {"boundary_lines", drawing.boundary_count},
          {"material_lines", drawing.material_lines.size()},
          {"bolts", drawing.bolts.size()},
          {"fixed_lines", drawing.fixed_lines.size()},
          {"loading_points", drawing.loading_points.size()},
          {"measured_points", drawing.measured_points.size()},
          {"hole_points", drawing.hole_points.size()}};
}

Json counts_of(const Blocks& blocks) {
  return {{"blocks", blocks.blocks.size()},
          {"bolts", blocks.bolts.size()},
          {"fixed_points", blocks.fixed_points.size()},
          {"loading_points", blocks.loading_points.size()},
          {"measured_points", blocks.measured_points.size()}};
}

Json counts_of(const Cover& cover) {
  return {{"elements", cover.elements.size()},
          {"covers", cover.nodes.size()},
          {"loops", cover.loops.size()},
          {"fixed_points", cover.fixed_points.size()},
          {"loading_points", cover.loading_points.size()},
          {"measured_points", cover.measured_points.size()}};
}

Json counts_of(const Analysis& analysis) {
  return {{"steps", analysis.step_count},
          {"block_materials", analysis.block_materials.size()},
          {"joint_materials", analysis.joint_materials.size()},
          {"load_curves", analysis.point_loads.size()},
          {"motion_curves", analysis.fixed_point_motions.size()}};
}

Json counts_of(const formats::Content& content) {
  Json counts = Json::object();
  if (content.drawing) counts.update(counts_of(*content.drawing));
  if (content.blocks) counts.update(counts_of(*content.blocks));
  if (content.cover) counts.update(counts_of(*content.cover));
  if (!content.frames.empty()) counts["frames"] = content.frames.size();
  if (!content.tracks.empty()) counts["measured_points"] = content.tracks.size();
  if (content.motion) counts["accelerations"] = content.motion->times.size();
  if (content.analysis) counts.update(counts_of(*content.analysis));
  return counts;
}

Json json_of(const formats::FileReading& file) {
  Json json = {{"file", file.path}};
  if (file.choice) {
    json["format"] = file.choice->format->name;
    json["evidence"] = file.choice->recognition.evidence;
  }
  if (file.reading) {
    json["counts"] = counts_of(file.reading->content);
    json["warnings"] = warning_list_json(file.reading->warnings);
  }
  if (file.error) json["error"] = file.error->what();
  return json;
}

std::string text_of(const Json& counts) {
  std::string text;
  for (const auto& [name, count] : counts.items()) {
    std::string words = name;
    for (char& c : words)
      if (c == '_') c = ' ';
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count.dump(), words);
  }
  return text;
}

void print(const Warnings& warnings) {
  for (const std::string& line : lines_of(warnings)) fmt::print("  {}\n", printable(line));
}

void print(const formats::FileReading& file) {
  if (file.choice)
    fmt::print("{}: {} [{}]: {}\n", printable(file.path), file.choice->format->title, file.choice->format->name,
               printable(file.choice->recognition.evidence));
  if (file.reading) {
    const std::string counts = text_of(counts_of(file.reading->content));
    fmt::print("  {}\n", counts.empty() ? "holds no geometry, analysis or results" : counts);
    print(file.reading->warnings);
  }
}

void print(const Requirements& plan) {
  fmt::print("  {} unknowns: {}\n", plan.unknowns, plan.basis);
  for (const RequiredTerm& term : plan.terms) fmt::print("  {:15} {}\n", name_of(term.term), term.reason);
}

std::string cost_in_words(const TrialSteps& trial, int steps) {
  if (!trial.starts)
    return fmt::format("cost: the start alone takes more than {:.2g} s; --trial 60 waits a minute for the first steps",
                       trial.start_seconds);
  const bool is_bound = trial.made == 0 && trial.failure.empty();
  const double all = trial.seconds_of(steps);
  return fmt::format("cost: start {:.2g} s, {}{:.2g} s per step ({} tried), {}{} for {}", trial.start_seconds,
                     is_bound ? "more than " : "", trial.step_seconds, trial.made, is_bound ? "more than " : "about ",
                     all < kSeconds ? fmt::format("{:.2g} s", all) : time_in_words(all),
                     counted(static_cast<std::size_t>(steps), "step"));
}

Json json_of(const TrialSteps& trial, int steps) {
  return {{"start_seconds", to_microseconds(trial.start_seconds)},
          {"step_seconds", trial.starts ? Json(to_microseconds(trial.step_seconds)) : Json()},
          {"steps_tried", trial.made},
          {"steps", steps},
          {"seconds_in_all", trial.starts ? Json(to_microseconds(trial.seconds_of(steps))) : Json()},
          {"failure", trial.failure}};
}

void print(const CaseReport& report) {
  if (report.warnings.empty() && !report.plan && report.lacks.empty()) return;
  fmt::print("the files together:\n");
  print(report.warnings);
  if (report.lacks == "analysis")
    fmt::print(
        "  no analysis: a run needs a case file with steps and materials; `keyblock new block` writes an example\n");
  if (report.lacks == "geometry") fmt::print("  no geometry: a run needs a drawing, blocks or a cover\n");
  if (report.plan) fmt::print("  profile {}, because {}\n", report.profile.name, printable(report.profile.why));
  if (report.plan) print(*report.plan);
  if (!report.size.empty()) fmt::print("  size: {}\n", report.size);
  if (!report.smallest_block.empty()) fmt::print("  {}\n", report.smallest_block);
  if (report.trial) fmt::print("  {}\n", cost_in_words(*report.trial, report.steps));
  for (const std::string& stage : report.stages) fmt::print("  {}\n", printable(stage));
}

/// Several geometries or analyses do not form one case: each file is checked alone, and the second gives this warning.
Warnings several_cases(const std::vector<formats::FileReading>& files) {
  std::vector<std::string> geometries, analyses;
  for (const formats::FileReading& file : files) {
    if (!file.reading) continue;
    const formats::Content& content = file.reading->content;
    if (content.drawing || content.blocks || content.cover) geometries.push_back(file.path);
    if (content.analysis) analyses.push_back(file.path);
  }
  const auto told = [](const std::vector<std::string>& found, const char* noun) {
    Facts facts{{{"count", found.size()}}, {{"noun", noun}}};
    facts.names = {{"file", found[0]}};
    return Warnings{warning_of({"several_cases", std::move(facts)}, {found[1], 0, 0})};
  };
  if (geometries.size() > 1) return told(geometries, "geometry");
  if (analyses.size() > 1) return told(analyses, "analysis");
  return {};
}

/// Returns the steps and the duration of each stage; empty for a case without stages.
std::vector<std::string> stages_of(const Scene& first) {
  std::vector<std::string> sentences;
  if (first.end.steps == 0) return sentences;
  for (const Scene* scene : scenes_of(first)) {
    const Model& model = scene->model;
    sentences.push_back(fmt::format(
        "stage {}{}: {}, {}, {} of {:.6g}{}", sentences.size() + 1,
        scene->end.name.empty() ? "" : fmt::format(" ({})", scene->end.name),
        counted(model.elements.size(), model.nodes.empty() ? "block" : "element"), counted(model.bolts.size(), "bolt"),
        counted(static_cast<std::size_t>(scene->end.steps), "step"), scene->settings.time_step,
        scene->end.equilibrium ? fmt::format(", or fewer if forces balance to {:.3g}", *scene->end.equilibrium) : ""));
  }
  return sentences;
}

// Tests the start of the run, and measures the time of a step.
void try_steps(CaseReport& report, const Scene& scene, double seconds, const Place& place) {
  try {
    report.trial = trial_steps(scene, seconds, std::min(kTrialSteps, report.steps));
  } catch (const std::invalid_argument& error) {
    report.trial = TrialSteps{.starts = true, .failure = error.what()};
  }
  if (!report.trial->failure.empty())
    report.warnings.push_back(warning_of({"first_steps_fail", {{}, {{"why", report.trial->failure}}}}, place));
}

/// Returns the warnings of a run about its histories before the first step. Throws InputError for a history of a
/// missing part, like a run.
Warnings look_at_histories(const Problem& problem, const Prepared& prepared) {
  require_choice(problem.outputs);
  const DrawnJoints joints(prepared.scene.model, prepared.joint_lines);
  return Followed(problem.outputs.histories, prepared.scene, joints, problem.units).of_distant_pairs();
}

std::string lacking_part(const Problem& problem) {
  const bool has_geometry = !std::holds_alternative<std::monostate>(problem.geometry);
  if (has_geometry == problem.analysis.has_value()) return {};
  return has_geometry ? "analysis" : "geometry";
}

CaseReport report_of(const std::vector<formats::FileReading>& files, const AskedCase& asked, double trial_seconds) {
  std::vector<formats::Content> contents;
  for (const formats::FileReading& file : files)
    if (file.reading) contents.push_back(file.reading->content);
  if (Warnings told = several_cases(files); !told.empty()) return {std::move(told), {}, std::nullopt};
  try {
    Checked checked = check(formats::pair(contents));
    CaseReport report{checked.warnings, {}, std::nullopt};
    report.units = checked.problem.units;
    for (const InputError& error : checked.errors) report.errors.emplace_back(error.what());
    if (const auto* cover = std::get_if<Cover>(&checked.problem.geometry); cover && report.errors.empty())
      manifold_of(*cover);  // throws if elements and loops do not fit together
    if (report.errors.empty()) report.lacks = lacking_part(checked.problem);
    if (!can_prepare(checked.problem) || !report.errors.empty()) return report;
    const PlannedCase plan = planned(asked, checked.problem);
    const Problem& problem = plan.problem;
    const Prepared& prepared = plan.prepared;
    report.profile = plan.profile;
    report.warnings = joined(std::move(report.warnings), plan.warnings);
    report.warnings = joined(std::move(report.warnings), look_at_histories(problem, prepared));
    report.plan = prepared.requirements;
    report.settings = all_settings_json(prepared.scene.settings);
    report.stages = stages_of(prepared.scene);
    report.size = size_of_scene(prepared.scene.model, checked.problem.units);
    report.smallest_block = smallest_block(prepared.blocks);
    report.steps = prepared.scene.settings.step_count;
    if (trial_seconds > 0) try_steps(report, prepared.scene, trial_seconds, problem.analysis->place);
    return report;
  } catch (const InputError& error) {
    return {{}, {error.what()}, std::nullopt};
  }
}

void print_json(const std::vector<formats::FileReading>& files, const CaseReport& report) {
  Json json = {{"files", Json::array()},
               {"case", {{"warnings", warning_list_json(report.warnings)}, {"errors", report.errors}}}};
  if (report.plan) {
    json["case"]["profile"] = report.profile.name;
    json["case"]["profile_because"] = report.profile.why;
    if (!report.size.empty()) json["case"]["size"] = report.size;
    if (!report.smallest_block.empty()) json["case"]["smallest_block"] = report.smallest_block;
    if (report.trial) json["case"]["cost"] = json_of(*report.trial, report.steps);
    json["case"]["requires"] = requirements_json(*report.plan);
    json["case"]["settings"] = report.settings;
  }
  if (report.units != Units{}) json["case"]["unit_by_letters"] = units_by_letters(report.units);
  if (!report.lacks.empty()) json["case"]["lacks"] = report.lacks;
  if (!report.stages.empty()) json["case"]["stages"] = report.stages;
  for (const formats::FileReading& file : files) json["files"].push_back(json_of(file));
  fmt::print("{}\n", json.dump(2, ' ', false, Json::error_handler_t::replace));
}

/// Prints errors to standard error, after the report; returns their number.
std::size_t log_errors(const std::vector<formats::FileReading>& files, const CaseReport& report) {
  std::vector<std::string> errors;
  for (const formats::FileReading& file : files)
    if (file.error) errors.emplace_back(file.error->what());
  errors.insert(errors.end(), report.errors.begin(), report.errors.end());
  std::fflush(stdout);
  for (const std::string& error : errors) spdlog::error("{}", error);
  return errors.size();
}

// A folder may be given for one case, or alone for many.
void require_one_case(const CaseOptions& given) {
  for (const std::string& path : given.paths) {
    if (!std::filesystem::is_directory(path)) continue;
    if (given.paths.size() == 1 && find_cases({path}).size() == 1) continue;
    throw UsageError(fmt::format(
        "check: expected files, the folder of one case, or a folder of cases alone; found the folder {} {}", path,
        given.paths.size() > 1              ? "among others"
        : given.reading != DrawingOptions{} ? "and --layers, --unit or --join"
        : !given.sets.empty()               ? "and --set"
        : !given.values.empty()             ? "and --at"
                                            : "and --settings-file"));
  }
}

// Returns false for the folder of one case, whose files are taken together.
bool is_folder_of_cases(const std::vector<std::string>& paths) {
  if (paths.size() != 1 || !std::filesystem::is_directory(paths.front())) return false;
  try {
    return find_cases({paths.front()}).size() != 1;
  } catch (const InputError&) {
    return true;  // files without expected values
  }
}

ExitCode check_files(const CheckOptions& options) {
  const CaseOptions& given = options.given;
  if (is_folder_of_cases(given.paths) && given.reading == DrawingOptions{} && given.sets.empty() &&
      given.values.empty() && given.settings_file.empty())
    return check_folder(given.paths.front(), given.profile, options.as_json);
  require_one_case(given);
  const AskedCase asked = case_of(given);
  std::vector<formats::FileReading> files = formats::read_files(asked.files, asked.choices);
  if (!asked.values.empty()) files = with_values(formats::case_of(std::move(files)), asked.values).files;
  const CaseReport report = report_of(files, asked, options.trial_seconds);
  if (options.as_json) {
    print_json(files, report);
  } else {
    for (const formats::FileReading& file : files) print(file);
    print(report);
  }
  if (log_errors(files, report) > 0) return ExitCode::unreadable;
  if (!report.trial || report.trial->failure.empty()) return ExitCode::ok;
  spdlog::error("keyblock: error: a run of this case fails, as its trial does: {}", report.trial->failure);
  return ExitCode::check_failed;
}

}  // namespace

Action configure_check(CLI::App& options) {
  const auto chosen = std::make_shared<CheckOptions>();
  add_case_options(
      options, chosen->given,
      "geometry and analysis files in any order, the folder of a case, or a folder of cases (one line each)")
      .files->required();
  options
      .add_option("--trial", chosen->trial_seconds,
                  fmt::format("seconds for trial steps, which show whether a run starts and estimate its time "
                              "(default: {:g}); 0: no trial",
                              kTrialSeconds))
      ->check(zero_or_above());
  options.add_flag("--json", chosen->as_json, "print the report as JSON");
  return [chosen] { return check_files(*chosen); };
}

}  // namespace keyblock
