// `keyblock tradeoff`: runs a case with many settings; finds the Pareto front of cost and error, and settings for a
// target.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <memory>
#include <numeric>

#include "app/command.hpp"
#include "app/helpers/picture_file.hpp"
#include "app/option_checks.hpp"
#include "app/stop_request.hpp"
#include "app/trade/tradeoff_map.hpp"
#include "base/context.hpp"
#include "base/counted.hpp"
#include "base/error.hpp"
#include "job/files.hpp"
#include "report/tradeoff_picture.hpp"
#include "run/settings_file.hpp"
#include "study/trade/run_design.hpp"

namespace keyblock {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using study::MeasuredRun;
using study::Tradeoff;

struct TradeoffOptions : MapOptions {
  bool is_map = false;
  bool is_full = false;
  std::vector<std::string> vary;
  std::size_t most = 200;
  std::string budget;
  double error = 0;  ///< 0: none requested
  std::string output;

  bool has_wish() const { return !budget.empty() || error > 0; }
};

// Parses "10s", "500 ms", "2min", "10".
double seconds_of(const std::string& text) {
  double number = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
  std::string unit(end, text.data() + text.size());
  std::erase(unit, ' ');
  double factor = 0;
  for (const auto& [name, value] :
       {std::pair{"", 1.0}, std::pair{"s", 1.0}, std::pair{"ms", 1e-3}, std::pair{"min", 60.0}, std::pair{"h", 3600.0}})
    if (unit == name) factor = value;
  if (fault != std::errc() || factor == 0 || !(number > 0) || !std::isfinite(number))
    throw UsageError(fmt::format("--budget: expected a time above 0 in ms, s, min or h, found \"{}\"", text));
  return number * factor;
}

study::Wish wish_of(const TradeoffOptions& options) {
  study::Wish wish;
  if (!options.budget.empty()) wish.budget = seconds_of(options.budget);
  if (options.error > 0) wish.error = options.error;
  return wish;
}

bool is_on_front(const Tradeoff& result, std::size_t run) {
  return std::ranges::find(result.front, run) != result.front.end();
}

std::string error_text(const Tradeoff& result, std::size_t i) {
  const double error = study::error_of(result.runs[i], result.reference);
  if (!std::isfinite(error)) return "-";
  const bool is_told_apart = error >= std::max(study::kLeastError, result.reference.uncertainty);
  return fmt::format("{}{:.{}e}", is_told_apart ? "" : "<", result.prices[i].error, is_told_apart ? 2 : 1);
}

// Sorts by cost, runs without a result last.
std::vector<std::size_t> by_cost(const Tradeoff& result) {
  std::vector<std::size_t> order(result.runs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) {
    return std::pair(!std::isfinite(result.prices[i].error), result.prices[i].seconds);
  });
  return order;
}

std::string table_of(const Tradeoff& result) {
  std::size_t width = 10;
  for (const MeasuredRun& run : result.runs) width = std::max(width, run.plan.name.size());
  std::string table =
      fmt::format("\n{}\n  {}\n  {:{}} {:>8} {:>9} {:>10} {:>9} {:>10}  on the front\n", result.name,
                  reference_words(result.reference), "run", width, "steps", "unknowns", "CPU s", "error", "over front");
  for (const std::size_t i : by_cost(result)) {
    const MeasuredRun& run = result.runs[i];
    if (run.end == study::MeasuredEnd::stopped && run.timings == 0) continue;  // no result to print
    const double over = over_front(result.prices, i);
    table +=
        fmt::format("  {:{}} {:>8} {:>9} {:>10.3g} {:>9} {:>10}  {}\n", run.plan.name, width, run.steps, run.unknowns,
                    run.seconds, error_text(result, i), std::isfinite(over) ? fmt::format("{:.2f}", over) : "-",
                    is_on_front(result, i)                    ? "*"
                    : over <= study::kTimingNoise             ? "~"
                    : run.end != study::MeasuredEnd::finished ? fmt::format("{}: {}", name_of(run.end), run.reason)
                    : std::isfinite(result.prices[i].error) || result.reference.values.empty()
                        ? ""
                        : "ends before all expected values are reached");
  }
  return table +
         fmt::format("  {}; the least of the timings counts; * on the front, ~ within a tenth\n", machine_words());
}

std::string picture_of(const Tradeoff& result) {
  const bool is_limit = !result.reference.is_expected;
  report::TradeoffPicture picture{
      fmt::format("{}: error and cost", result.name),
      is_limit ? fmt::format("error against the limit of refined steps, known to {:.1e}", result.reference.uncertainty)
               : "error against the expected values",
      {},
      std::max(study::kLeastError, result.reference.uncertainty)};
  for (std::size_t i = 0; i < result.runs.size(); ++i) {
    const MeasuredRun& run = result.runs[i];
    if (!std::isfinite(result.prices[i].error) || run.seconds <= 0) continue;
    picture.runs.push_back(
        {run.plan.name, run.seconds, result.prices[i].error, run.plan.group == "profile", is_on_front(result, i),
         over_front(result.prices, i) <= study::kTimingNoise,
         fmt::format("{}: {:.3g} s, error {}, {}, {} unknowns", run.plan.name, run.seconds, error_text(result, i),
                     counted(static_cast<std::size_t>(run.steps), "step"), run.unknowns)});
  }
  return tradeoff_picture(picture);
}

// Returns all settings of the run, each name once with its last value; files are named relative to the settings file.
SettingsFile settings_of(const study::StudyCase& chosen, const study::RunPlan& plan, const fs::path& file) {
  SettingsFile settings{plan.profile, {}};
  std::vector<Override> all = chosen.overrides(plan.profile);
  all.insert(all.end(), plan.set.begin(), plan.set.end());
  for (auto [name, value] : all) {
    if (name == "body_acceleration_file" && !value.empty())
      value = fs::proximate(fs::absolute(value), fs::absolute(file).parent_path()).string();
    const auto known = std::ranges::find(settings.settings, name, &Override::first);
    if (known == settings.settings.end())
      settings.settings.emplace_back(name, value);
    else
      known->second = value;
  }
  return settings;
}

std::string wish_words(const study::Wish& wish) {
  std::string words;
  if (wish.budget) words = fmt::format("at most {:g} s", *wish.budget);
  if (wish.error) words += fmt::format("{}an error of at most {:g}", words.empty() ? "" : " and ", *wish.error);
  return words;
}

std::string output_of(const TradeoffOptions& options, const study::StudyCase& chosen) {
  if (!options.has_wish() || !options.output.empty()) return options.output;
  return fs::path(chosen.name).filename().string() + ".settings";
}

Json json_of(const Tradeoff& result, const study::StudyCase& chosen, const study::Wish& wish,
             std::optional<std::size_t> choice, const std::string& file) {
  Json runs = Json::array();
  for (std::size_t i = 0; i < result.runs.size(); ++i) {
    const MeasuredRun& run = result.runs[i];
    runs.push_back({{"name", run.plan.name},
                    {"group", run.plan.group},
                    {"profile", run.plan.profile},
                    {"set", settings_json(run.plan.set)},
                    {"end", name_of(run.end)},
                    {"reason", run.reason},
                    {"steps", run.steps},
                    {"unknowns", run.unknowns},
                    {"cpu_seconds", run.seconds},
                    {"timings", run.timings},
                    {"error", json_number(study::error_of(run, result.reference))},
                    {"error_bound", json_number(result.prices[i].error)},
                    {"on_front", is_on_front(result, i)},
                    {"over_front", json_number(over_front(result.prices, i))}});
  }
  Json front = Json::array();
  for (const std::size_t i : result.front) front.push_back(result.runs[i].plan.name);
  Json asked = {{"budget", wish.budget ? Json(*wish.budget) : Json()},
                {"error", wish.error ? Json(*wish.error) : Json()}};
  return {{"case", result.name},
          {"common", settings_json(chosen.common)},
          {"reference", reference_json(result.reference)},
          {"machine", machine_json()},
          {"runs", runs},
          {"front", front},
          {"wish", asked},
          {"choice", choice ? Json(result.runs[*choice].plan.name) : Json()},
          {"settings_file", choice ? Json(file) : Json()}};
}

// Names the nearest run if none meets the target.
std::string words_of_nearest(const Tradeoff& result, const study::Wish& wish) {
  if (result.front.empty()) return "no run gave a result";
  const std::size_t best = result.front.back();
  const std::size_t cheapest = result.front.front();
  const bool too_far = wish.error && result.prices[best].error > *wish.error;
  const std::size_t shown = too_far ? best : cheapest;
  return fmt::format("the {} is \"{}\" with {:.3g} s and an error of {}", too_far ? "most accurate" : "cheapest",
                     result.runs[shown].plan.name, result.runs[shown].seconds, error_text(result, shown));
}

bool is_guess(const Tradeoff& result, std::size_t run) {
  return result.prices[run].error < result.reference.guessed_below();
}

ExitCode run_tradeoff(const TradeoffOptions& options) {
  const study::Wish wish = wish_of(options);
  if (!options.output.empty() && !options.has_wish())
    throw UsageError("-o is for the settings that meet --budget or --error: neither is given");
  require_picture_name("--picture", options.picture);
  const study::StudyCase chosen = case_asked(options);
  const std::string file = output_of(options, chosen);
  require_writable({file, options.picture}, {options.paths.begin(), options.paths.end()}, overwrite_if(options.force));
  const std::vector<study::RunPlan> plans =
      options.is_full ? study::full_design(chosen, options.profile, options.most, options.vary)
                      : study::usual_design(chosen, options.profile, options.vary);
  const std::vector<study::RunPlan> limit_from = study::refinements(chosen, options.profile, options.finest);
  const study::Search search{wish, [&](const study::RunPlan& plan, int parts) {
                               return study::refined(chosen, options.profile, plan, parts);
                             }};
  const Tradeoff result = study::tradeoff(chosen, plans, limit_from, options.limits(), tell_run, search);
  const bool chooses = options.has_wish() && !result.is_stopped;
  const auto choice = chooses ? study::choice_for(result.prices, wish) : std::nullopt;
  if (!options.picture.empty()) write_picture(options.picture, picture_of(result), overwrite_if(options.force));
  if (choice) {
    const MeasuredRun& run = result.runs[*choice];
    write_output(file,
                 settings_text(settings_of(chosen, run.plan, file),
                               fmt::format("{}: \"{}\", {:.3g} s of processor time, error {}\nfor {}{}", result.name,
                                           run.plan.name, run.seconds, error_text(result, *choice), wish_words(wish),
                                           is_guess(result, *choice) ? "\n" + words_of_doubt(result.reference) : "")),
                 overwrite_if(options.force));
  }
  if (options.as_json)
    fmt::print("{}\n", json_of(result, chosen, wish, choice, file).dump(1, ' ', false, Json::error_handler_t::replace));
  else
    fmt::print("{}", table_of(result));
  std::fflush(stdout);
  if (choice)
    spdlog::info("chosen for {}: \"{}\", error {}; keyblock run … --settings-file {}", wish_words(wish),
                 result.runs[*choice].plan.name, error_text(result, *choice), file);
  if (chooses && !choice) spdlog::error("no run meets {}; {}", wish_words(wish), words_of_nearest(result, wish));
  if (result.is_stopped && options.has_wish()) spdlog::warn("no settings were picked");
  if (result.is_stopped) return stopped_with(result);
  if (result.front.empty()) return ExitCode::numerical_failure;
  const bool is_in_doubt = choice ? is_guess(result, *choice) : is_in_doubt_as_a_whole(result.reference);
  if (is_in_doubt) spdlog::error("{}", words_of_doubt(result.reference));
  return is_in_doubt || (chooses && !choice) ? ExitCode::check_failed : ExitCode::ok;
}

/// Adds the options of the map, which has runs and outputs of its own.
void add_map_options(CLI::App& options, TradeoffOptions& chosen) {
  CLI::Option* map = options.add_flag("--map", chosen.is_map, "map the error over contact stiffness and step instead");
  for (const char* name : {"--vary", "--full", "--most", "--budget", "--error", "--output"})
    map->excludes(options.get_option(name));
  options.add_option("--penalties", chosen.penalties, "factors on the contact stiffness (default: 100 10 1 0.1 0.01)")
      ->delimiter(',')
      ->check(above_zero())
      ->needs(map);
  options.add_option("--steps", chosen.steps, "factors on the step (default: 4 2 1 0.5 0.25)")
      ->delimiter(',')
      ->check(above_zero())
      ->needs(map);
  options.add_option("--table", chosen.table, "write the map as a table (CSV)")->type_name("FILE")->needs(map);
}

}  // namespace

Action configure_tradeoff(CLI::App& options) {
  const auto chosen = std::make_shared<TradeoffOptions>();
  add_study_options(options, *chosen);
  options
      .add_option("--vary", chosen->vary,
                  "vary only these settings: basis, step, enforcement, penalty, tolerance, integrator, impact, forces, "
                  "functions, mesh")
      ->delimiter(',');
  options.add_flag("--full", chosen->is_full, "run all combinations instead of single changes and the usual pairs");
  options.add_option("--most", chosen->most, "largest number of runs of --full (default: 200)")->check(above_zero());
  options.add_option(
      "--budget", chosen->budget,
      "pick the most accurate run within this time (10s, 500ms, 2min); the study itself takes several times as long");
  options.add_option("--error", chosen->error, "pick the fastest run within this error, e.g. 1e-3")
      ->check(above_zero());
  options
      .add_option("-o,--output", chosen->output,
                  "file for the picked settings, for run --settings-file (default: CASE.settings)")
      ->type_name("FILE");
  add_map_options(options, *chosen);
  return [chosen] {
    context().use_threads(1);  // costs are processor time
    listen_for_stops();
    return chosen->is_map ? map_errors(*chosen) : run_tradeoff(*chosen);
  };
}

}  // namespace keyblock
