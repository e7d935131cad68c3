// Checks before the first trial, prints a table during the trials, writes files at the end.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/strength/strength_reduction.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "app/messages.hpp"
#include "app/option_checks.hpp"
#include "app/stop_request.hpp"
#include "app/strength/trial_watch.hpp"
#include "base/error.hpp"
#include "base/printable.hpp"
#include "job/files.hpp"
#include "job/recorded_run.hpp"
#include "job/run_heading.hpp"
#include "job/run_report.hpp"
#include "problem/units/measure.hpp"
#include "report/rock/strength_picture.hpp"
#include "study/strength/mesh_error.hpp"
#include "study/strength/strength_plan.hpp"

namespace keyblock {
namespace {

using Json = nlohmann::ordered_json;
using study::Bracket;
using study::FactorOfSafety;
using study::SearchEnd;
using study::StrengthTrial;
using study::Verdict;

/// Case after reading, and the plan of its search.
struct ReducedCase : OpenCase {
  study::StrengthPlan plan;
};

constexpr double kLower = 20;  // ratio of the failed limit and the one that a message proposes
constexpr std::array<const char*, 4> kFiles{"fos.json", "trials.csv", "picture.svg", "fos.svg"};

Json number_or_none(const std::optional<double>& value) {
  return value ? Json(*value) : Json();
}

Json bracket_json(const Bracket& bracket) {
  return {{"stands", number_or_none(bracket.stands)}, {"falls", number_or_none(bracket.falls)}};
}

Json blocks_json(const std::vector<int>& blocks) {
  Json numbers = Json::array();
  for (const int block : blocks) numbers.push_back(block + 1);
  return numbers;
}

std::string kind_of(const StrengthTrial& trial) {
  if (trial.is_far) return "far away";
  if (trial.verdict == study::Verdict::undecided) return "undecided";
  return trial.verdict == study::Verdict::stands ? "stable" : "unstable";
}

Json trial_json(const StrengthTrial& trial) {
  return {{"factor", trial.factor},
          {"verdict", study::name_of(trial.verdict)},
          {"balanced", trial.is_balanced},
          {"far", trial.is_far},
          {"past_knee", trial.is_past_knee},
          {"why", trial.why},
          {"largest_displacement", trial.displacement},
          {"largest_over_width", trial.is_balanced ? Json(trial.farthest.share()) : Json()},
          {"rounds", trial.rounds},
          {"systems", trial.systems}};
}

// Serviceability: null if displacements do not grow before failure.
Json service_json(const FactorOfSafety& found) {
  if (!found.grows_before_it_falls()) return {};
  Json json = bracket_json(found.service);
  json["factor"] = found.service.middle();
  return json;
}

Json mesh_error_json(const std::optional<study::MeshError>& error) {
  if (!error) return {};
  if (!error->coarse) return {{"why_none", error->why_none}};
  return {{"coarse_mesh_times", study::kCoarserTimes},
          {"coarse_factor", error->coarse->middle()},
          {"coarse_bracket", bracket_json(*error->coarse)},
          {"relative_error", error->share},
          {"least_error", error->least},
          {"greatest_error", error->most},
          {"uncertainty", error->uncertainty},
          {"extrapolated_factor", error->extrapolated}};
}

/// Adds what the numbers are of: units, input files, and the values that were changed after reading.
void put_origin(Json& json, const ReducedCase& chosen) {
  json.update(origin_json(chosen.input.problem.units, chosen.read_files(), chosen.plan.trials.made()));
  if (!chosen.values.empty()) json["values"] = values_json(chosen.values);
}

/// Returns the record up to the first trial.
Json json_of(const ReducedCase& chosen) {
  const study::StrengthTrials& trials = chosen.plan.trials;
  Json json = plan_json(chosen.name, trials.made().profile, trials.prepared());
  json["settings_replaced"] = settings_json_of(trials.replaced());
  json["reduced"] = name_of(trials.what());
  return json;
}

Json json_of(const ReducedCase& chosen, const FactorOfSafety& found, bool has_files) {
  Json trials = Json::array();
  for (const StrengthTrial& trial : found.trials) trials.push_back(trial_json(trial));
  Json json = json_of(chosen);
  json.update({{"end", study::name_of(found.end)},
               {"factor_of_safety", found.end == SearchEnd::bracketed ? Json(found.bracket.middle()) : Json()},
               {"bracket", bracket_json(found.bracket)},
               {"to_within", found.within},
               {"far_over_width", kFarFromDrawing},
               {"serviceability", service_json(found)},
               {"knee_times", study::kKnee},
               {"mesh_error", mesh_error_json(found.mesh_error)},
               {"exempt", chosen.plan.reduction.exempt},
               {"lower_estimate", found.is_lower_estimate},
               {"left_out", blocks_json(found.left_out)},
               {"notes", found.notes},
               {"warnings", warning_list_json(chosen.plan.warnings)},
               {"trials", trials}});
  put_origin(json, chosen);
  json["outputs"] = Json::array();
  if (has_files) json["outputs"] = kFiles;
  return json;
}

std::string csv_of(const FactorOfSafety& found, const Units& units) {
  std::string csv = fmt::format("factor,verdict,balanced,far,past_knee,{},rounds,systems,why\n",
                                with_declared("largest_displacement", measures::kLength, units));
  for (const StrengthTrial& t : found.trials)
    csv += fmt::format("{},{},{},{},{},{},{},{},{}\n", t.factor, study::name_of(t.verdict), t.is_balanced, t.is_far,
                       t.is_past_knee, t.displacement, t.rounds, t.systems, csv_cell(t.why));
  return csv;
}

std::string answer_of(const FactorOfSafety& found) {
  if (found.end == SearchEnd::stopped) return "stopped before a factor of safety was found";
  if (found.end != SearchEnd::bracketed) return "no factor of safety";
  const bool is_high_by_mesh = found.mesh_error && found.mesh_error->coarse && found.mesh_error->share > 0;
  const char* kind = found.is_lower_estimate && !is_high_by_mesh ? " (a lower estimate)" : "";
  return fmt::format("factor of safety{} {:.4g}", kind, found.bracket.middle());
}

std::string sentence_of(const FactorOfSafety& found) {
  const Bracket& at = found.bracket;
  switch (found.end) {
    case SearchEnd::bracketed:
      return fmt::format("{}: stable at {:.6g}, unstable at {:.6g}", answer_of(found), *at.stands, *at.falls);
    case SearchEnd::falls:
      return fmt::format("no bracket: unstable at {:.6g}, the least factor tried; --from {:.3g} begins lower",
                         *at.falls, *at.falls / kLower);
    case SearchEnd::stands:
      return fmt::format("no bracket: stable at {:.6g}, the largest factor tried; --to {:.3g} goes further", *at.stands,
                         *at.stands * kLower);
    case SearchEnd::undecided:
    case SearchEnd::stopped:
      break;
  }
  const std::string known = at.stands && at.falls
                                ? fmt::format("stable at {:.6g}, unstable at {:.6g}", *at.stands, *at.falls)
                            : at.stands ? fmt::format("stable at {:.6g}, no unstable factor is known", *at.stands)
                            : at.falls  ? fmt::format("unstable at {:.6g}, no stable factor is known", *at.falls)
                                        : std::string("no stable or unstable factor is known");
  return fmt::format("{}: {}", found.end == SearchEnd::stopped ? "stopped" : "no factor of safety", known);
}

std::string table_of(const ReducedCase& chosen, const FactorOfSafety& found) {
  std::string table =
      fmt::format("{}: strength of {} divided by F\n{:>10}  {:<14}{:>14}{:>12}  {}\n", chosen.name,
                  found.what == Reduced::both ? "joints and rock" : name_of(found.what), "F", "",
                  with_declared("displacement", measures::kLength, chosen.input.problem.units), "iterations", "why");
  std::vector<StrengthTrial> trials = found.trials;
  std::ranges::sort(trials, {}, &StrengthTrial::factor);
  for (const StrengthTrial& t : trials)
    table +=
        fmt::format("{:>10.6g}  {:<14}{:>14.4g}{:>12}  {}\n", t.factor, kind_of(t), t.displacement, t.rounds, t.why);
  table += sentence_of(found) + "\n";
  for (const std::string& note : found.notes) table += fmt::format("note: {}\n", note);
  return table;
}

FieldFrame as_drawn(FieldFrame field) {
  for (FieldElement& element : field.elements) {
    element.middle.displacement = {};
    for (auto& loop : element.loops)
      for (FieldCorner& corner : loop) corner.displacement = {};
  }
  return field;
}

// Draws bolts at their original places; a bolt at its strength counts as broken.
std::vector<report::StrengthBolt> bolts_of(const Model& model, const FactorOfSafety& found) {
  std::vector<report::StrengthBolt> bolts;
  for (std::size_t i = 0; i < model.bolts.size(); ++i) {
    const Bolt& bolt = model.bolts[i];
    report::StrengthBolt& out = bolts.emplace_back();
    out.at = {bolt.first.start, bolt.second.start};
    if (!found.standing || i >= found.standing->frame.bolts.size()) continue;
    const BoltFrame& now = found.standing->frame.bolts[i];
    out.is_at_strength = now.is_broken;
    out.force = now.is_broken ? bolt.strength : now.force;
  }
  return bolts;
}

report::StrengthPicture picture_of(const ReducedCase& chosen, const FactorOfSafety& found) {
  report::StrengthPicture picture;
  picture.title = fmt::format("{}: {}", chosen.name, answer_of(found));
  picture.falling_words =
      found.bracket.falls ? fmt::format("unstable at F = {:.6g}", *found.bracket.falls) : "no unstable factor";
  picture.falling = found.falling;
  picture.units = chosen.input.problem.units;
  picture.bolts = bolts_of(chosen.plan.trials.prepared().scene.model, found);
  if (found.standing) {
    picture.standing = found.standing->field;
    picture.plastic_strains = found.standing->plastic_strains;
    picture.standing_words = fmt::format("stable at F = {:.6g}", *found.bracket.stands);
    picture.before = found.before_fall.value_or(found.standing->field);
  } else {
    picture.standing_words = "as drawn; it is stable at no factor that was tried";
    if (found.falling) picture.standing = picture.before = as_drawn(*found.falling);
  }
  return picture;
}

report::StrengthChart chart_of(const ReducedCase& chosen, const FactorOfSafety& found) {
  using Kind = report::StrengthPoint::Kind;
  report::StrengthChart chart{fmt::format("{}: largest displacement over F", chosen.name),
                              {},
                              found.bracket.stands,
                              found.bracket.falls,
                              chosen.input.problem.units};
  if (found.grows_before_it_falls()) chart.service = found.service.falls;
  for (const StrengthTrial& trial : found.trials)
    chart.points.push_back({trial.factor, trial.displacement,
                            trial.verdict == Verdict::stands  ? Kind::stands
                            : trial.verdict == Verdict::falls ? Kind::falls
                                                              : Kind::undecided});
  return chart;
}

void write_files(const ReducedCase& chosen, const ReductionOptions& options, const FactorOfSafety& found,
                 const std::string& json) {
  const std::filesystem::path folder = options.folder;
  std::filesystem::create_directories(folder);
  const auto write = [&](const char* name, const std::string& text) {
    write_output(folder / name, text, overwrite_if(options.force));
  };
  write(kFiles[0], json + "\n");
  write(kFiles[1], csv_of(found, chosen.input.problem.units));
  write(kFiles[2], report::strength_picture(picture_of(chosen, found)));
  write(kFiles[3], report::strength_chart(chart_of(chosen, found)));
}

void require_free_folder(const OpenCase& chosen, const ReductionOptions& options) {
  if (options.folder.empty()) return;
  if (std::filesystem::exists(options.folder) && !std::filesystem::is_directory(options.folder))
    throw UsageError(fmt::format("{}: expected a folder, found a file", options.folder));
  for (const char* name : kFiles)
    require_free(std::filesystem::path(options.folder) / name, overwrite_if(options.force));
  for (const std::string& file : chosen.files) require_not_below(file, options.folder);
}

bool was_stopped(const FactorOfSafety& found) {
  return found.end == SearchEnd::stopped || (found.mesh_error && found.mesh_error->is_stopped);
}

ExitCode exit_code(const FactorOfSafety& found) {
  if (!was_stopped(found)) return found.is_safe() ? ExitCode::ok : ExitCode::check_failed;
  return is_at_time_limit() ? ExitCode::limit : ExitCode::stopped;
}

CLI::Validator count_of_systems() {
  const auto refused = [](const std::string& text) -> std::string {
    const bool is_count =
        !text.empty() && text.find_first_not_of("0123456789") == std::string::npos && text.size() < 16;
    if (is_count) return {};
    return fmt::format(
        "expected a whole number of linear solves, 0 for no limit, found {}; the limit is not in seconds, "
        "so that it does not depend on the machine",
        text);
  };
  return {refused, ""};
}

ReducedCase reduced_case(const AskedCase& asked, const ReductionOptions& options) {
  OpenCase open = opened(asked);
  require_free_folder(open, options);
  ReductionAsked given = options.asked;
  if (!options.what.empty()) given.what = reduced_of(options.what);
  study::StrengthPlan plan = study::strength_plan(open, open.input, given);
  return {std::move(open), std::move(plan)};
}

std::string text_of(const Json& json) {
  return json.dump(1, ' ', false, Json::error_handler_t::replace);
}

FactorOfSafety found_for(const ReducedCase& chosen, const ReductionOptions& options) {
  study::PlannedSearch search;
  search.trial_limit = options.trial_limit;
  search.seeks_mesh_error = options.seeks_mesh_error;
  TrialWatch watch;
  search.on_begin = [&](double factor) { watch.begin(factor); };
  search.on_trial = [&](const StrengthTrial& trial) {
    watch.end();
    spdlog::info("F = {:.6g}: {}{}{}", trial.factor, kind_of(trial), trial.why.empty() ? "" : ": ", trial.why);
  };
  search.on_loose = [](const std::string& sentence) { spdlog::info("{}; the search begins anew", sentence); };
  search.on_coarser_mesh = [] { spdlog::info("on a coarser mesh, for the error of the mesh:"); };
  return study::factor_of_safety(chosen.plan, search);
}

}  // namespace

std::vector<CLI::Option*> add_reduction_options(CLI::App& options, ReductionOptions& chosen) {
  return {
      options
          .add_option("--from", chosen.asked.from,
                      "first factor, at which the case must be stable (default: 1, or less if unstable at 1)")
          ->check(above_zero()),
      options.add_option("--to", chosen.asked.to, "largest factor (default: 16 times the first)")->check(above_zero()),
      options.add_option("--to-within", chosen.asked.within, "final width of the bracket (default: 0.01)")
          ->check(above_zero()),
      options
          .add_option(
              "--trial-limit", chosen.trial_limit,
              "linear solves per trial (default: 100,000, or 10 times the longest trial before if that is more); 0: no "
              "limit. A longer trial is undecided, and the search ends with the bracket so far")
          ->type_name("SYSTEMS")
          ->check(count_of_systems()),
      options
          .add_option("--exempt", chosen.asked.exempt,
                      "keep the strength of material:N, joint_material:N, box:x1,y1,x2,y2 or "
                      "polygon:x1,y1,x2,y2,x3,y3,…; may be repeated")
          ->type_name("WHAT")
          ->take_all(),
      options.add_flag("!--no-mesh-error", chosen.seeks_mesh_error,
                       "do not estimate the mesh error by a second search on a coarser mesh")};
}

ExitCode reduce_strength(const AskedCase& asked, const ReductionOptions& options) {
  const ReducedCase chosen = reduced_case(asked, options);
  log_by_level(chosen.plan.warnings, "the case");
  if (options.plan_only) fmt::print("{}\n", text_of(json_of(chosen)));
  if (!chosen.plan.refusal.empty()) {
    spdlog::error("{}: error: {}", chosen.files.front(), chosen.plan.refusal);
    spdlog::info("  help: {}", chosen.plan.help);
    return ExitCode::numerical_failure;
  }
  if (options.plan_only) return ExitCode::ok;
  listen_for_stops();
  const FactorOfSafety found = found_for(chosen, options);
  const std::string json = text_of(json_of(chosen, found, !options.folder.empty()));
  if (options.as_json)
    fmt::print("{}\n", json);
  else
    fmt::print("{}", table_of(chosen, found));
  if (!options.folder.empty()) write_files(chosen, options, found, json);
  if (was_stopped(found))
    spdlog::warn("stopped {}", is_at_time_limit() ? "at the limit of processor time" : "by request");
  return exit_code(found);
}

}  // namespace keyblock
