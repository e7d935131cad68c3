// `keyblock sweep`: runs a case over any values, or maps its error over contact stiffness and step.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "app/command.hpp"
#include "app/commands/study_options.hpp"
#include "app/helpers/picture_file.hpp"
#include "app/input/value_sweep_options.hpp"
#include "app/option_checks.hpp"
#include "app/stop_request.hpp"
#include "base/context.hpp"
#include "base/error.hpp"
#include "job/files.hpp"
#include "problem/units/measure.hpp"
#include "report/sweep_picture.hpp"
#include "study/trade/run_design.hpp"

namespace keyblock {
namespace {

using Json = nlohmann::ordered_json;
using study::MeasuredEnd;
using study::MeasuredRun;
using study::Tradeoff;

struct SweepOptions : StudyOptions {
  std::vector<double> penalties{100, 10, 1, 0.1, 0.01};
  std::vector<double> steps{4, 2, 1, 0.5, 0.25};
  std::string table;
};

/// Map of runs, which come first in the result, row by row.
struct Map {
  const SweepOptions& options;
  const Tradeoff& result;
  const Units& units;

  const MeasuredRun& run(std::size_t row, std::size_t column) const {
    return result.runs[row * options.steps.size() + column];
  }
  double error(std::size_t row, std::size_t column) const { return error_of(run(row, column), result.reference); }
  std::string value(std::size_t row, std::size_t column, const char* setting) const {
    const std::vector<Override>& set = run(row, column).plan.set;
    const auto found = std::ranges::find(set, setting, &Override::first);
    return found == set.end() ? "" : found->second;
  }
  std::string penalty(std::size_t row) const {
    return fmt::format("{:.3g}", std::stod(value(row, 0, "contact_penalty")));
  }
  // A run may end without reaching the compared values.
  std::string verdict(std::size_t row, std::size_t column) const {
    const MeasuredRun& made = run(row, column);
    if (result.reference.values.empty()) return name_of(made.end);  // stopped before the reference was known
    return made.end == MeasuredEnd::finished && !std::isfinite(error(row, column)) ? "not reached" : name_of(made.end);
  }
  std::string cell(std::size_t row, std::size_t column) const {
    const double found = error(row, column);
    return std::isfinite(found) ? fmt::format("{:.2e}", found) : verdict(row, column);
  }
};

std::string factor(double value) {
  return value >= 1 ? fmt::format("x{:g}", value) : fmt::format("/{:g}", 1 / value);
}

std::string table_of(const Map& map) {
  const SweepOptions& options = map.options;
  std::string table =
      fmt::format("\n{}\n  {}\n  {:>24}", map.result.name, reference_words(map.result.reference), "penalty \\ step");
  for (const double step : options.steps) table += fmt::format(" {:>12}", factor(step));
  table += "\n";
  for (std::size_t r = 0; r < options.penalties.size(); ++r) {
    table += fmt::format("  {:>8} {:>15}", factor(options.penalties[r]), map.penalty(r));
    for (std::size_t c = 0; c < options.steps.size(); ++c) table += fmt::format(" {:>12}", map.cell(r, c));
    table += "\n";
  }
  return table + fmt::format("  {}\n", machine_words());
}

std::string csv_of(const Map& map) {
  std::string csv = fmt::format("penalty_factor,{},step_factor,steps,verdict,error,cpu_seconds\n",
                                with_declared("contact_penalty", measures::kStiffness, map.units));
  for (std::size_t r = 0; r < map.options.penalties.size(); ++r)
    for (std::size_t c = 0; c < map.options.steps.size(); ++c) {
      const double error = map.error(r, c);
      csv += fmt::format("{},{},{},{},{},{},{}\n", map.options.penalties[r], map.value(r, c, "contact_penalty"),
                         map.options.steps[c], map.run(r, c).steps, map.verdict(r, c),
                         std::isfinite(error) ? fmt::format("{}", error) : "", map.run(r, c).seconds);
    }
  return csv;
}

Json json_of(const Map& map) {
  Json cells = Json::array();
  for (std::size_t r = 0; r < map.options.penalties.size(); ++r)
    for (std::size_t c = 0; c < map.options.steps.size(); ++c)
      cells.push_back({{"penalty_factor", map.options.penalties[r]},
                       {"step_factor", map.options.steps[c]},
                       {"set", settings_json(map.run(r, c).plan.set)},
                       {"verdict", map.verdict(r, c)},
                       {"reason", map.run(r, c).reason},
                       {"steps", map.run(r, c).steps},
                       {"error", json_number(map.error(r, c))},
                       {"cpu_seconds", map.run(r, c).seconds}});
  return {{"case", map.result.name},
          {"reference", reference_json(map.result.reference)},
          {"machine", machine_json()},
          {"cells", cells}};
}

std::string picture_of(const Map& map) {
  report::SweepPicture picture{
      fmt::format("{}: error over contact stiffness and step", map.result.name),
      map.result.reference.is_expected
          ? "against the expected values"
          : fmt::format("against the limit of refined steps, known to {:.1e}", map.result.reference.uncertainty),
      {},
      {},
      "step, over the case's own",
      with_unit("contact stiffness", measures::kStiffness, map.units),
      {}};
  for (const double step : map.options.steps) picture.columns.push_back(factor(step));
  for (std::size_t r = 0; r < map.options.penalties.size(); ++r) {
    picture.rows.push_back(fmt::format("{}  ({})", map.penalty(r), factor(map.options.penalties[r])));
    auto& row = picture.cells.emplace_back();
    for (std::size_t c = 0; c < map.options.steps.size(); ++c) {
      const MeasuredRun& run = map.run(r, c);
      const double error = map.error(r, c);
      const double shown = std::isfinite(error) ? std::max(error, study::kLeastError) : error;
      row.push_back({shown, map.verdict(r, c),
                     fmt::format("{}: {}, {:.3g} s{}{}", run.plan.name, map.cell(r, c), run.seconds,
                                 run.reason.empty() ? "" : "; ", run.reason)});
    }
  }
  return sweep_picture(picture);
}

ExitCode run_sweep(const SweepOptions& options) {
  require_picture_name("--picture", options.picture);
  const study::StudyCase chosen = case_asked(options);
  require_no_picture_name("--table", options.table, "--picture");
  require_writable({options.table, options.picture}, {options.paths.begin(), options.paths.end()},
                   overwrite_if(options.force));
  const std::vector<study::RunPlan> plans =
      study::penalty_step_map(chosen, options.profile, options.penalties, options.steps);
  const std::vector<study::RunPlan> limit_from = study::refinements(chosen, options.profile, options.finest);
  const Tradeoff result = study::tradeoff(chosen, plans, limit_from, options.limits(), tell_run);
  const Map map{options, result, chosen.input.problem.units};
  if (!options.picture.empty()) write_picture(options.picture, picture_of(map), overwrite_if(options.force));
  if (!options.table.empty()) write_output(options.table, csv_of(map), overwrite_if(options.force));
  if (options.as_json)
    fmt::print("{}\n", json_of(map).dump(1, ' ', false, Json::error_handler_t::replace));
  else
    fmt::print("{}", table_of(map));
  if (result.is_stopped) return stopped_with(result);
  const bool has_results = std::ranges::any_of(
      result.runs, [&](const MeasuredRun& run) { return std::isfinite(error_of(run, result.reference)); });
  if (!has_results) return ExitCode::numerical_failure;
  if (!is_in_doubt_as_a_whole(result.reference)) return ExitCode::ok;
  spdlog::error("{}", words_of_doubt(result.reference));
  return ExitCode::check_failed;
}

/// Adds the options of a sweep over values; those without which they have no meaning are needed.
void add_value_options(CLI::App& options, ValueSweepOptions& chosen) {
  options
      .add_option("--over", chosen.over,
                  "run the case over values of a key: /POINTER=20:40:2, /POINTER=0,50 kN, SETTING=A,B, "
                  "joints:/POINTER=normal(35,3); may be repeated; names and * stand for numbers of list items")
      ->type_name("KEY=VALUES")
      ->take_all();
  options.add_option("--design", chosen.design_file, "rows of values instead of --over: a JSON list of objects")
      ->type_name("FILE");
  options
      .add_option("--random", chosen.random,
                  "N rows of a Latin hypercube over lists and over normal(MEAN,DEVIATION), lognormal(MEAN,DEVIATION), "
                  "uniform(LOW,HIGH) and triangular(LOW,MODE,HIGH)")
      ->type_name("N")
      ->check(above_zero());
  options.add_option("--seed", chosen.seed, "seed of --random (default: 1)");
  options.add_flag("--zip", chosen.is_zipped, "take first values of all keys together, then second ones, …");
  options.add_option("--joints", chosen.joints, "statistics of joints (docs/slope.json), drawn anew for each row")
      ->type_name("FILE");
  options.add_option("--out", chosen.out,
                     "results of a row, separated by commas: displacement, speed, state, steps, time, blocks, fos, "
                     "fos_rock, point1.dx, NAME.vx of a history, ledger.kinetic, tip1.k1, /pointer into run.json "
                     "(default: displacement)");
  options.add_option("--history", chosen.histories, "follow a quantity, as `keyblock run --history`; may be repeated")
      ->type_name("[NAME=]WHAT")
      ->take_all();
  options.add_option("--to-within", chosen.within, "final width of the bracket of fos")->check(above_zero());
}

/// Adds the options by which jobs are done: those of `batch` too.
void add_job_options(CLI::App& options, ValueSweepOptions& chosen) {
  options
      .add_option("-o,--output", chosen.folder,
                  "folder for table.csv, columns.csv, times.csv, sweep.svg, sweep.json, journals and jobs")
      ->type_name("FOLDER");
  options.add_option("--jobs", chosen.jobs, "jobs at a time (default: number of cores)")->check(CLI::Range(1, 1024));
  options.add_option("--time-limit", chosen.cpu_seconds, "processor time per process, seconds (default: no limit)")
      ->check(above_zero());
  options.add_option("--memory-limit", chosen.memory_mebibytes, "address space per process, MiB (default: no limit)")
      ->check(above_zero());
  options.add_flag("--resume", chosen.is_resumed, "do the missing jobs of the sweep in FOLDER, from their checkpoints");
  options.add_option("--shard", chosen.shard, "do only jobs of shard K of N, also on another machine")
      ->type_name("K/N");
  options.add_flag("--merge", chosen.is_merged, "run nothing; write the table of all shards in FOLDER");
  options.add_option("--slurm", chosen.slurm, "print an array script of N shards for sbatch, and run nothing")
      ->type_name("N")
      ->check(CLI::Range(1, 100'000));
  options.add_option("--parallel", chosen.parallel, "print a line of N shards for GNU parallel, and run nothing")
      ->type_name("N")
      ->check(CLI::Range(1, 100'000));
}

/// Refuses options of the map in a sweep over values, and the reverse.
void require_one_kind(const CLI::App& options, bool is_over_values) {
  const std::vector<const char*> of_map{"--against",   "--finest", "--repeat", "--limit",
                                        "--penalties", "--steps",  "--table",  "--picture"};
  const std::vector<const char*> of_values{
      "--random", "--seed",  "--zip",      "--joints",        "--out",          "--history", "--to-within",
      "-o",       "--at",    "--jobs",     "--time-limit",    "--memory-limit", "--resume",  "--shard",
      "--merge",  "--slurm", "--parallel", "--settings-file", "--layers",       "--unit",    "--join"};
  for (const char* name : is_over_values ? of_map : of_values)
    if (options.count(name) > 0)
      throw UsageError(fmt::format("sweep: {} belongs to {}", name,
                                   is_over_values ? "the map of errors, without --over" : "a sweep with --over"));
}

}  // namespace

Action configure_sweep(CLI::App& options) {
  const auto map = std::make_shared<SweepOptions>();
  const auto values = std::make_shared<ValueSweepOptions>();
  add_study_options(options, *map);
  add_value_options(options, *values);
  add_job_options(options, *values);
  options.add_option("--at", values->given.values, "give the case another value in all rows, as `keyblock run --at`")
      ->type_name("POINTER=VALUE")
      ->take_all();
  options.add_option("--settings-file", values->given.settings_file, "settings of all rows, as `keyblock run`")
      ->type_name("FILE");
  add_drawing_options(options, values->given.reading);
  options.add_option("--penalties", map->penalties, "factors on the contact stiffness (default: 100 10 1 0.1 0.01)")
      ->delimiter(',')
      ->check(above_zero());
  options.add_option("--steps", map->steps, "factors on the step (default: 4 2 1 0.5 0.25)")
      ->delimiter(',')
      ->check(above_zero());
  options.add_option("--table", map->table, "write the map as a table (CSV)")->type_name("FILE");
  return [map, values, &options] {
    require_one_kind(options, values->is_asked());
    if (values->is_asked()) {
      values->given.paths = map->paths;
      values->given.sets = map->sets;
      if (options.count("--profile") > 0) values->given.profile = map->profile;
      values->as_json = map->as_json;
      values->force = map->force;
      return sweep_values(*values);
    }
    context().use_threads(1);  // costs are processor time
    listen_for_stops();
    return run_sweep(*map);
  };
}

}  // namespace keyblock
