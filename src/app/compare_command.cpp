// `keyblock compare`: reruns cases against their expected values, and traces of the old program step by step.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/command.hpp"
#include "app/files.hpp"
#include "app/run_report.hpp"
#include "app/usage_error.hpp"
#include "report/run_picture.hpp"
#include "run/profile.hpp"
#include "study/compare.hpp"
#include "study/trace.hpp"

namespace keyblock {
namespace {

using Json = nlohmann::ordered_json;
using study::ComparedCase;
using study::ComparedValue;
using study::TraceDifference;

struct CompareOptions {
  std::vector<std::string> cases = {"legacy_cases"};
  std::string profile = "legacy";
  std::string picture;
  bool as_json = false;
  bool with_sources = false;
};

std::string name_of(const ComparedValue& value) {
  return value.block ? fmt::format("{} of block {}", value.quantity, *value.block) : value.quantity;
}

std::string relative_error(const ComparedValue& value) {
  if (!value.computed || value.expected == 0) return "-";
  return fmt::format("{:.3f} %", 100 * value.error() / std::abs(value.expected));
}

void print(const ComparedCase& compared, const CompareOptions& options) {
  fmt::print("\n{}  ({} steps to time {:.6g})\n", compared.name, compared.outcome.steps, compared.outcome.time);
  if (compared.outcome.end != RunEnd::finished) fmt::print("  the run ended early: {}\n", compared.outcome.reason);
  fmt::print("  {:26} {:>8} {:>16} {:>16} {:>11} {:>10} {:>10}\n", "quantity", "time", "expected", "computed", "error",
             "relative", "tolerance");
  for (const ComparedValue& v : compared.values) {
    const std::string computed = v.computed ? fmt::format("{:.9g}", *v.computed) : "not reached";
    fmt::print("  {:26} {:>8.6g} {:>16.9g} {:>16} {:>11.2e} {:>10} {:>10.1e}  {}\n", name_of(v), v.time, v.expected,
               computed, v.error(), relative_error(v), v.tolerance, v.holds() ? "ok" : "MISSED");
  }
  std::string last;
  for (const ComparedValue& v : compared.values) {
    if (v.source == last && !options.with_sources) continue;
    last = v.source;
    fmt::print("  source: {}: {}\n", name_of(v), v.source);
    if (options.with_sources) fmt::print("  tolerance: {}\n", v.tolerance_reason);
  }
}

void print(const std::vector<TraceDifference>& traces) {
  if (traces.empty()) return;
  fmt::print(
      "\ntraces of the Berkeley program (dt, oci, contacts, closed, penalty equal in every step; rest within "
      "{:.0e})\n",
      study::kTraceTolerance);
  fmt::print("  {:42} {:>11} {:>8} {:>9} {:>9} {:>9} {:>9} {:>10}\n", "trace", "steps", "equal?", "polygon", "position",
             "rotation", "stress", "disp_ratio");
  for (const TraceDifference& t : traces) {
    fmt::print("  {:42} {:>11} {:>8} {:>9.1e} {:>9.1e} {:>9.1e} {:>9.1e} {:>10.1e}  {}\n", t.name,
               fmt::format("{}/{}", t.steps, t.steps_in_trace), t.unequal.empty() ? "yes" : "NO", t.polygon, t.position,
               t.rotation, t.stress, t.disp_ratio, t.holds() ? "ok" : "MISSED");
    for (const std::string& text : t.unequal) fmt::print("    {}\n", text);
  }
}

Json json_of(const ComparedCase& compared) {
  Json values = Json::array();
  for (const ComparedValue& v : compared.values) {
    values.push_back({{"quantity", v.quantity},
                      {"block", v.block ? Json(*v.block) : Json()},
                      {"time", v.time},
                      {"expected", v.expected},
                      {"computed", v.computed ? Json(*v.computed) : Json()},
                      {"tolerance", v.tolerance},
                      {"tolerance_reason", v.tolerance_reason},
                      {"source", v.source},
                      {"holds", v.holds()}});
  }
  return {
      {"case", compared.name}, {"holds", compared.holds()}, {"reason", compared.outcome.reason}, {"values", values}};
}

Json json_of(const TraceDifference& t) {
  return {{"trace", t.name},        {"holds", t.holds()},
          {"steps", t.steps},       {"steps_in_trace", t.steps_in_trace},
          {"unequal", t.unequal},   {"polygon", t.polygon},
          {"position", t.position}, {"rotation", t.rotation},
          {"stress", t.stress},     {"disp_ratio", t.disp_ratio}};
}

// Start, end, and the displacement of the first block named beside its expected values.
std::string picture_of(const ComparedCase& compared) {
  report::Curve run{fmt::format("computed, {} steps", compared.outcome.steps), compared.times, compared.displacements,
                    report::Curve::Style::line};
  report::Curve theory{"expected", {}, {}, report::Curve::Style::points};
  for (const ComparedValue& v : compared.values) {
    if (v.quantity != "displacement") continue;
    theory.x.push_back(v.time);
    theory.y.push_back(v.expected);
  }
  return report::run_picture({compared.name,
                              compared.start,
                              compared.end,
                              {run, theory},
                              {"time [s]", fmt::format("displacement of block {} [m]", compared.followed_block)},
                              "s"});
}

/// All cases and traces rerun, and the names of those that could not be run.
struct Comparison {
  std::vector<ComparedCase> cases;
  std::vector<TraceDifference> traces;
  std::vector<std::string> refused;

  /// Reruns one folder. A case that cannot be run is told and counted; the others go on.
  void add(const study::CaseFolder& folder, const CompareOptions& options) {
    try {
      if (folder.has_expected) cases.push_back(study::compare_case(folder, options.profile));
      if (folder.has_trace) traces.push_back(study::follow_trace(folder));
    } catch (const InputError& error) {
      spdlog::error("{}", error.what());
      refused.push_back(folder.name);
    }
  }

  std::size_t missed() const {
    return refused.size() +
           static_cast<std::size_t>(std::ranges::count_if(cases, [](const ComparedCase& c) { return !c.holds(); }) +
                                    std::ranges::count_if(traces, [](const TraceDifference& t) { return !t.holds(); }));
  }
};

void print_json(const Comparison& all) {
  Json json = {{"cases", Json::array()}, {"traces", Json::array()}, {"refused", all.refused}};
  for (const ComparedCase& c : all.cases) json["cases"].push_back(json_of(c));
  for (const TraceDifference& t : all.traces) json["traces"].push_back(json_of(t));
  fmt::print("{}\n", json.dump(1));
}

ExitCode compare(const CompareOptions& options) {
  Comparison all;
  for (const study::CaseFolder& folder : study::find_cases(options.cases)) {
    const std::size_t before = all.cases.size();
    all.add(folder, options);
    if (all.cases.size() > before && !options.as_json) print(all.cases.back(), options);
  }
  if (!options.picture.empty()) {
    if (all.cases.size() != 1) throw UsageError("--picture: expected one case with expected values");
    write_file(options.picture, picture_of(all.cases.front()));
  }
  if (options.as_json)
    print_json(all);
  else
    print(all.traces);
  std::fflush(stdout);  // the table before the verdict, wherever both go
  spdlog::info("{}, {}, {} missed", counted(all.cases.size(), "case"), counted(all.traces.size(), "trace"),
               all.missed());
  if (all.cases.empty() && all.traces.empty()) return ExitCode::unreadable;
  return all.missed() == 0 ? ExitCode::ok : ExitCode::check_failed;
}

}  // namespace

Action configure_compare(CLI::App& options) {
  const auto chosen = std::make_shared<CompareOptions>();
  options.add_option("cases", chosen->cases, "case folders, or folders of cases")->capture_default_str();
  options.add_option("--profile", chosen->profile, "preset of all choices for cases; traces are of profile legacy")
      ->check(CLI::IsMember(profile_names()))
      ->capture_default_str();
  options.add_option("--picture", chosen->picture, "write a picture of the one case given (SVG)");
  options.add_flag("--sources", chosen->with_sources,
                   "print the source and the reason of the tolerance of every value");
  options.add_flag("--json", chosen->as_json, "print the tables as JSON");
  return [chosen] { return compare(*chosen); };
}

}  // namespace keyblock
