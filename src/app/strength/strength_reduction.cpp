// Checks before the first trial, a table as trials come, files at the end.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/strength/strength_reduction.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/option_checks.hpp"
#include "app/stop_request.hpp"
#include "app/strength/trial_watch.hpp"
#include "base/error.hpp"
#include "base/printable.hpp"
#include "base/stop.hpp"
#include "formats/case.hpp"
#include "job/files.hpp"
#include "job/run_report.hpp"
#include "problem/units/measure.hpp"
#include "report/rock/strength_picture.hpp"
#include "run/look_ahead.hpp"
#include "study/strength/factor_of_safety.hpp"

namespace keyblock {
namespace {

using Json = nlohmann::ordered_json;
using study::Bracket;
using study::FactorOfSafety;
using study::SearchEnd;
using study::StrengthTrial;
using study::Verdict;

/// The case as it was read.
struct ReducedCase {
  std::string name;
  std::vector<std::string> files;
  formats::Case input;
  std::string profile;
  std::vector<Override> overrides;
};

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
  return trial.is_past_knee ? "past the knee" : study::name_of(trial.verdict);
}

Json trial_json(const StrengthTrial& trial) {
  return {{"factor", trial.factor},
          {"verdict", study::name_of(trial.verdict)},
          {"balanced", trial.is_balanced},
          {"past_knee", trial.is_past_knee},
          {"why", trial.why},
          {"largest_displacement", trial.displacement},
          {"rounds", trial.rounds}};
}

Json json_of(const ReducedCase& chosen, const FactorOfSafety& found) {
  Json trials = Json::array();
  for (const StrengthTrial& trial : found.trials) trials.push_back(trial_json(trial));
  return {{"program", "keyblock"},
          {"version", KEYBLOCK_VERSION},
          {"case", chosen.name},
          {"profile", chosen.profile},
          {"reduced", study::name_of(found.what)},
          {"end", study::name_of(found.end)},
          {"factor_of_safety", found.end == SearchEnd::bracketed ? Json(found.bracket.middle()) : Json()},
          {"bracket", bracket_json(found.bracket)},
          {"to_within", found.within},
          {"equilibrium", bracket_json(found.equilibrium)},
          {"knee_times", study::kKnee},
          {"lower_estimate", found.is_lower_estimate},
          {"left_out", blocks_json(found.left_out)},
          {"notes", found.notes},
          {"trials", trials}};
}

std::string csv_of(const FactorOfSafety& found, const Units& units) {
  std::string csv = fmt::format("factor,verdict,balanced,past_knee,{},rounds,why\n",
                                with_declared("largest_displacement", measures::kLength, units));
  for (const StrengthTrial& t : found.trials)
    csv += fmt::format("{},{},{},{},{},{},{}\n", t.factor, study::name_of(t.verdict), t.is_balanced, t.is_past_knee,
                       t.displacement, t.rounds, csv_cell(t.why));
  return csv;
}

std::string sentence_of(const FactorOfSafety& found) {
  const Bracket& at = found.bracket;
  const char* kind = found.is_lower_estimate ? " (a lower estimate)" : "";
  switch (found.end) {
    case SearchEnd::bracketed:
      return fmt::format("factor of safety{} {:.4g}: stands at {:.6g}, falls at {:.6g}", kind, at.middle(), *at.stands,
                         *at.falls);
    case SearchEnd::falls:
      return fmt::format("no bracket: it falls at {:.6g}, the least factor tried", *at.falls);
    case SearchEnd::stands:
      return fmt::format("no bracket: it stands at {:.6g}, the largest factor tried", *at.stands);
    case SearchEnd::undecided:
    case SearchEnd::stopped:
      break;
  }
  return fmt::format("no bracket to {:g}{}{}", found.within,
                     at.stands ? fmt::format(": stands at {:.6g}", *at.stands) : "",
                     at.falls ? fmt::format("; falls at {:.6g}", *at.falls) : "");
}

std::string table_of(const ReducedCase& chosen, const FactorOfSafety& found) {
  std::string table =
      fmt::format("{}: strength of {} divided by F\n{:>10}  {:<14}{:>14}{:>8}  {}\n", chosen.name,
                  found.what == study::Reduced::both ? "joints and rock" : study::name_of(found.what), "F", "",
                  with_declared("displacement", measures::kLength, chosen.input.problem.units), "rounds", "why");
  std::vector<StrengthTrial> trials = found.trials;
  std::ranges::sort(trials, {}, &StrengthTrial::factor);
  for (const StrengthTrial& t : trials)
    table +=
        fmt::format("{:>10.6g}  {:<14}{:>14.4g}{:>8}  {}\n", t.factor, kind_of(t), t.displacement, t.rounds, t.why);
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

report::StrengthPicture picture_of(const ReducedCase& chosen, const FactorOfSafety& found) {
  report::StrengthPicture picture;
  picture.title = fmt::format("{}: {}", chosen.name, sentence_of(found));
  picture.falling_words =
      found.bracket.falls ? fmt::format("falls at F = {:.6g}", *found.bracket.falls) : "nothing falls";
  picture.falling = found.falling;
  picture.units = chosen.input.problem.units;
  if (found.standing) {
    picture.standing = found.standing->field;
    picture.plastic_strains = found.standing->plastic_strains;
    picture.standing_words = fmt::format("stands at F = {:.6g}", *found.bracket.stands);
    picture.before = found.standing->field;
  } else {
    picture.standing_words = "as drawn; it stands at no factor that was tried";
    if (found.falling) picture.standing = picture.before = as_drawn(*found.falling);
  }
  return picture;
}

report::StrengthChart chart_of(const ReducedCase& chosen, const FactorOfSafety& found) {
  report::StrengthChart chart{fmt::format("{}: largest displacement over F", chosen.name),
                              {},
                              found.bracket.stands,
                              found.bracket.falls,
                              chosen.input.problem.units};
  for (const StrengthTrial& trial : found.trials)
    chart.points.push_back({trial.factor, trial.displacement, trial.verdict == Verdict::stands});
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

void require_options(const ReducedCase& chosen, const ReductionOptions& options) {
  if (options.from && options.to && !(*options.to > *options.from))
    throw UsageError(fmt::format("--to: expected more than --from {}, found {}", *options.from, *options.to));
  if (!options.from && options.to && !(*options.to > 1))
    throw UsageError(fmt::format("--to: expected more than 1, where no --from is given, found {}", *options.to));
  if (options.folder.empty()) return;
  if (std::filesystem::exists(options.folder) && !std::filesystem::is_directory(options.folder))
    throw UsageError(fmt::format("{}: expected a folder, found a file", options.folder));
  for (const char* name : kFiles)
    require_free(std::filesystem::path(options.folder) / name, overwrite_if(options.force));
  for (const std::string& file : chosen.files) require_not_below(file, options.folder);
}

study::StrengthTrials trials_of(const ReducedCase& chosen, const ReductionOptions& options) {
  study::ConfiguredProblem made = study::configured(chosen.input.problem, chosen.overrides);
  return {std::move(made.problem), chosen.profile, std::move(made.overrides), study::reduced_of(options.what)};
}

ExitCode exit_code(const FactorOfSafety& found) {
  if (found.end != SearchEnd::stopped) return found.is_safe() ? ExitCode::ok : ExitCode::check_failed;
  return is_at_time_limit() ? ExitCode::limit : ExitCode::stopped;
}

ReducedCase reduced_case(const study::AskedCase& asked) {
  ReducedCase chosen{asked.name, asked.files, formats::load_case(asked.files, asked.choices), {}, {}};
  chosen.profile = study::profile_for(asked, chosen.input.problem, study::OldFiles::standard).name;
  chosen.overrides = asked.overrides(chosen.profile);
  return chosen;
}

// What is not asked for, as `case.json` says.
ReductionOptions with_those_of_case(ReductionOptions options, const study::CaseFile& file) {
  if (const auto& asked = file.reduction) {
    if (options.what.empty()) options.what = study::name_of(asked->what);
    if (!options.from) options.from = asked->from;
    if (!options.to) options.to = asked->to;
    if (!options.within) options.within = asked->within;
  }
  if (options.what.empty()) options.what = "joints";
  return options;
}

}  // namespace

std::vector<CLI::Option*> add_reduction_options(CLI::App& options, ReductionOptions& chosen) {
  return {
      options
          .add_option("--from", chosen.from,
                      "first factor, at which the case must stand (default: 1, and less where that falls)")
          ->check(above_zero()),
      options.add_option("--to", chosen.to, "largest factor (default: 16 times the first)")->check(above_zero()),
      options.add_option("--to-within", chosen.within, "width of the bracket (default: 0.01)")->check(above_zero()),
      options
          .add_option("--trial-limit", chosen.trial_limit,
                      "seconds after which a trial is given up as undecided, which ends the search with the bracket "
                      "that is known by then; 0: none (default: 60, beyond 6,000 unknowns one for each 100; or 10 "
                      "times the longest trial before, where that is more)")
          ->check(zero_or_above())};
}

ExitCode reduce_strength(const study::AskedCase& asked, const ReductionOptions& given) {
  const ReducedCase chosen = reduced_case(asked);
  const ReductionOptions options = with_those_of_case(given, asked.file);
  require_options(chosen, options);
  const study::StrengthTrials trials = trials_of(chosen, options);
  log_warnings(joined(joined(chosen.input.warnings, trials.prepared().warnings),
                      look_ahead(chosen.input.problem, trials.prepared())));
  listen_for_stops();
  study::SearchOptions search{options.from, options.to, options.within.value_or(0.01)};
  search.wants_stop = [] { return stop_signal() != 0 || is_stop_requested(); };
  TrialWatch watch(options.trial_limit, trials.prepared().requirements.unknowns);
  search.on_begin = [&](double factor) { watch.begin(factor); };
  search.why_given_up = [&]() -> std::string {
    if (stop_signal() != 0 || !watch.takes_back_stop()) return {};
    if (options.trial_limit) return fmt::format("given up after {:g} s (--trial-limit)", *options.trial_limit);
    return fmt::format("given up after {:.0f} s, the default of --trial-limit: --trial-limit 0 lets it go on",
                       *watch.limit());
  };
  search.on_trial = [&](const StrengthTrial& trial) {
    watch.end();
    spdlog::info("F = {:.6g}: {}{}{}", trial.factor, kind_of(trial), trial.why.empty() ? "" : ": ", trial.why);
  };
  search.on_loose = [](const std::string& sentence) { spdlog::info("{}; the search begins anew", sentence); };
  const FactorOfSafety found = study::factor_of_safety(trials, search);
  const std::string json = json_of(chosen, found).dump(1, ' ', false, Json::error_handler_t::replace);
  if (options.as_json)
    fmt::print("{}\n", json);
  else
    fmt::print("{}", table_of(chosen, found));
  if (!options.folder.empty()) write_files(chosen, options, found, json);
  if (found.end == SearchEnd::stopped)
    spdlog::warn("stopped {}", is_at_time_limit() ? "at the limit of processor time" : "by request");
  return exit_code(found);
}

}  // namespace keyblock
