// Load steps as they are solved; what they leave at the end.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/cover_run.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>

#include "app/stop_request.hpp"
#include "base/stop.hpp"
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
                      {"sxy", point.stress.xy},
                      {"szz", point.stress.zz}});
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

// Displacements of a linear solution are as large as its loads; one that turns an element over is not one of this body.
std::string turned_over(const Frame& start, const Frame& end) {
  if (start.elements.size() != end.elements.size()) return {};  // something was dug out
  for (std::size_t e = 0; e < end.elements.size(); ++e) {
    if (end.elements[e].area / start.elements[e].area > 0) continue;
    return fmt::format("element {} is turned over: the loads are too large for linear statics", e + 1);
  }
  return {};
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

namespace {

/// What the load steps of a run leave.
struct CoverRun {
  History history{true, {}};
  FieldFrame end;
  Frame last;
  Json steps = Json::array();
};

ExitCode finish(const CoverCase& cover_case, const CoverRunRequest& request, const Warnings& warnings,
                const CoverRun& run, RunFolder& folder) {
  folder.finish(report::field_picture(
                    {fmt::format("{}, {} functions, {} unknowns", request.title, name_of(cover_case.counts().functions),
                                 cover_case.counts().unknowns),
                     cover_case.start().field, run.end, run.last.measured_points, report::most_varied(run.end)}),
                run.history);
  const std::string doubt = turned_over(cover_case.start().frame, run.last);
  Json doubts = Json::array();
  if (!doubt.empty()) doubts.push_back(doubt);
  const Json json = {
      {"program", "keyblock"},
      {"version", KEYBLOCK_VERSION},
      {"profile", request.profile},
      {"outcome",
       {{"end", "finished"}, {"steps", run.history.rows.back().step}, {"time", run.end.time}, {"doubts", doubts}}},
      {"inputs", inputs_json(request.inputs)},
      {"counts", counts_json(cover_case.counts())},
      {"warnings", warnings_json(warnings)},
      {"seconds", {{"read", request.seconds_read}}},
      {"outputs", folder.outputs()},
      {"load_steps", run.steps}};
  const std::string text = json.dump(1, ' ', false, Json::error_handler_t::replace);
  folder.write_record(text + "\n");
  if (request.as_json) fmt::print("{}\n", text);
  spdlog::info("results in {}", request.folder);
  if (!doubt.empty()) spdlog::error("keyblock: error: the results are not to be trusted: {}", doubt);
  return doubt.empty() ? ExitCode::ok : ExitCode::check_failed;
}

}  // namespace

ExitCode run_covers(const formats::Case& loaded, const CoverRunRequest& request) {
  const CoverCase cover_case(loaded.problem, request.profile, request.overrides);
  RunFolder folder(request.folder, request.overwrite, Trace::no);
  listen_for_stops();
  bool has_begun = false;
  spdlog::info("{}", sentence_of(cover_case.counts()));
  const Warnings warnings = joined(loaded.warnings, cover_case.warnings());
  log_warnings(warnings);
  CoverRun run;
  const auto keep = [&](const SolvedStep& step) {
    folder.add(step.field);
    run.history.rows.push_back({step.step, step.time, step.frame.measured_points, {}});
    run.end = step.field;
    run.last = step.frame;
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
    run.steps.push_back(json_of(step));
    spdlog::info("load step {}: residual {:.1e}, forces balance to {:.1e}, {:.2f} s", step.step, step.residual,
                 unbalanced(step.balance), step.seconds);
    leave_if_stopped();
  };
  try {
    cover_case.run(on_step);
  } catch (const InputError&) {
    if (has_begun) folder.take_back();
    throw;
  } catch (const StopRequested&) {
    if (has_begun) folder.take_back();
    spdlog::warn("stopped; load steps that are solved at once leave nothing: run it anew");
    return is_at_time_limit() ? ExitCode::limit : ExitCode::stopped;
  }
  return finish(cover_case, request, warnings, run, folder);
}

}  // namespace keyblock
