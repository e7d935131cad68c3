// Maps the error of a case over contact stiffness and step; see tradeoff_map.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/trade/tradeoff_map.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>

#include "app/helpers/picture_file.hpp"
#include "app/option_checks.hpp"
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

/// Map of runs, which come first in the result, row by row.
struct Map {
  const MapOptions& options;
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
  const MapOptions& options = map.options;
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

}  // namespace

ExitCode map_errors(const MapOptions& options) {
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

}  // namespace keyblock
