// Load steps as they are solved; what they leave at the end.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/cover_run.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>

#include "job/run_folder.hpp"
#include "model/cover_basis.hpp"
#include "report/field_picture.hpp"

namespace keyblock {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Resultant& r) {
  return {{"x", r.force.x}, {"y", r.force.y}, {"moment", r.moment}};
}

/// What is left of all forces, over the largest of them.
double unbalanced(const ForceBalance& balance) {
  Resultant sum = balance.loads;
  double largest = length(balance.loads.force);
  sum.add(balance.springs);
  for (const Resultant& support : balance.supports) {
    sum.add(support);
    largest = std::max(largest, length(support.force));
  }
  return largest > 0 ? length(sum.force) / largest : length(sum.force);
}

Json json_of(const SolvedStep& step) {
  Json supports = Json::array();
  for (const Resultant& support : step.balance.supports) supports.push_back(json_of(support));
  Json points = Json::array();
  for (const PointFrame& point : step.frame.measured_points)
    points.push_back({{"dx", point.displacement.x},
                      {"dy", point.displacement.y},
                      {"sxx", point.stress.xx},
                      {"syy", point.stress.yy},
                      {"sxy", point.stress.xy}});
  return {{"step", step.step},
          {"time", step.time},
          {"elements", step.counts.elements},
          {"unknowns", step.counts.unknowns},
          {"residual", step.residual},
          {"refinements", step.refinements},
          {"factor_entries", step.factor_entries},
          {"processor_seconds", step.seconds},
          {"loads", json_of(step.balance.loads)},
          {"springs", json_of(step.balance.springs)},
          {"supports", supports},
          {"unbalanced", unbalanced(step.balance)},
          {"measured_points", points}};
}

}  // namespace

Json counts_json(const CoverCounts& counts) {
  return {{"functions", name_of(counts.functions)},
          {"bodies", counts.bodies},
          {"elements", counts.elements},
          {"covers", counts.covers},
          {"unknowns", counts.unknowns},
          {"load_steps", counts.load_steps},
          {"solves", counts.solves}};
}

std::string sentence_of(const CoverCounts& counts) {
  return fmt::format("{} unknowns: {} functions on {} physical covers, {} elements, {}; {} of {}", counts.unknowns,
                     name_of(counts.functions), counts.covers, counts.elements,
                     counts.bodies == 1 ? "1 body" : fmt::format("{} bodies", counts.bodies),
                     counts.solves == 1 ? "1 static solve" : fmt::format("{} static solves", counts.solves),
                     counts.load_steps == 1 ? "1 load step" : fmt::format("{} load steps", counts.load_steps));
}

ExitCode run_covers(const formats::Case& loaded, const CoverRunRequest& request) {
  const CoverCase cover_case(loaded.problem, request.profile, request.overrides);
  RunFolder folder(request.folder, request.overwrite, Trace::no);
  bool has_begun = false;
  spdlog::info("{}", sentence_of(cover_case.counts()));
  const Warnings warnings = joined(loaded.warnings, cover_case.warnings());
  log_warnings(warnings);
  History history{true, {}};
  FieldFrame end;
  std::vector<PointFrame> measured;
  Json steps = Json::array();
  const auto keep = [&](const SolvedStep& step) {
    folder.add(step.field);
    history.rows.push_back({step.step, step.time, step.frame.measured_points, {}});
    end = step.field;
    measured = step.frame.measured_points;
  };
  // Not before a step is solved: loads that turn out not to be finite leave nothing, and earlier results stay.
  const auto begin = [&] {
    if (has_begun) return;
    has_begun = true;
    folder.begin();
    keep(cover_case.start());
  };
  const auto on_step = [&](const SolvedStep& step) {
    begin();
    keep(step);
    steps.push_back(json_of(step));
    spdlog::info("load step {}: residual {:.1e}, forces balance to {:.1e}, {:.2f} s", step.step, step.residual,
                 unbalanced(step.balance), step.seconds);
  };
  try {
    cover_case.run(on_step);
  } catch (const InputError&) {
    if (has_begun) folder.take_back();
    throw;
  }
  folder.finish(
      report::field_picture({fmt::format("{}, {} functions, {} unknowns", request.title,
                                         name_of(cover_case.counts().functions), cover_case.counts().unknowns),
                             cover_case.start().field, end, measured, report::most_varied(end)}),
      history);
  const Json json = {{"program", "keyblock"},
                     {"version", KEYBLOCK_VERSION},
                     {"profile", request.profile},
                     {"outcome", {{"end", "finished"}, {"steps", history.rows.back().step}, {"time", end.time}}},
                     {"inputs", inputs_json(request.inputs)},
                     {"counts", counts_json(cover_case.counts())},
                     {"warnings", warnings_json(warnings)},
                     {"seconds", {{"read", request.seconds_read}}},
                     {"outputs", folder.outputs()},
                     {"load_steps", steps}};
  const std::string text = json.dump(1, ' ', false, Json::error_handler_t::replace);
  folder.write_record(text + "\n");
  if (request.as_json) fmt::print("{}\n", text);
  spdlog::info("results in {}", request.folder);
  return ExitCode::ok;
}

}  // namespace keyblock
