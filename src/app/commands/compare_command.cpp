// `keyblock compare`: reruns cases against their expected values, and traces of the Berkeley program step by step.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/command.hpp"
#include "app/commands/compare_table.hpp"
#include "app/helpers/picture_file.hpp"
#include "app/option_checks.hpp"
#include "base/counted.hpp"
#include "base/error.hpp"
#include "job/files.hpp"
#include "job/run_report.hpp"
#include "report/run_picture.hpp"
#include "settings/profile.hpp"

namespace keyblock {
namespace {

using Json = nlohmann::ordered_json;
using study::CaseComparison;
using study::ComparedCase;
using study::ComparedValue;
using study::TraceDifference;

struct CompareOptions {
  std::vector<std::string> cases = {"legacy_cases"};
  std::string profile;  ///< empty: legacy and standard
  std::string picture;
  bool as_json = false;
  bool with_sources = false;
  bool with_slow = false;
  bool force = false;

  std::vector<std::string> profiles() const { return profile.empty() ? rule_names() : std::vector{profile}; }
};

Json json_of(const ComparedValue& v) {
  return {{"quantity", v.quantity},
          {"block", v.block ? Json(*v.block) : Json()},
          {"time", v.time},
          {"expected", v.expected},
          {"computed", v.computed ? Json(*v.computed) : Json()},
          {"tolerance", v.tolerance},
          {"tolerance_reason", v.tolerance_reason},
          {"source", v.source},
          {"judged", v.is_judged},
          {"listed_miss", v.listed_miss},
          {"holds", v.holds()}};
}

Json json_of(const ComparedCase& run) {
  Json values = Json::array();
  for (const ComparedValue& v : run.values) values.push_back(json_of(v));
  return {{"profile", run.profile}, {"variant", run.variant},       {"holds", run.holds()},
          {"not_run", run.not_run}, {"reason", run.outcome.reason}, {"values", values}};
}

Json json_of(const CaseComparison& comparison) {
  Json runs = Json::array();
  for (const auto* list : {&comparison.plain, &comparison.variants})
    for (const ComparedCase& run : *list) runs.push_back(json_of(run));
  return {{"case", comparison.name}, {"holds", comparison.holds()}, {"runs", runs}};
}

Json json_of(const TraceDifference& t) {
  return {{"trace", t.name},        {"holds", t.holds()},
          {"steps", t.steps},       {"steps_in_trace", t.steps_in_trace},
          {"unequal", t.unequal},   {"polygon", t.polygon},
          {"position", t.position}, {"rotation", t.rotation},
          {"stress", t.stress},     {"disp_ratio", t.disp_ratio}};
}

// Draws start and end of the last profile that ran. Curves show the displacements of the first block named in the
// expected values, under all profiles.
std::string picture_of(const CaseComparison& comparison) {
  std::vector<report::Curve> curves;
  const ComparedCase* shown = &comparison.plain.front();
  for (const ComparedCase& run : comparison.plain) {
    if (run.times.empty()) continue;
    shown = &run;
    curves.push_back({fmt::format("{}, {} steps", run.profile, run.outcome.steps), run.times, run.displacements,
                      report::Curve::Style::line});
  }
  report::Curve theory{"expected", {}, {}, report::Curve::Style::points};
  for (const ComparedValue& v : shown->values) {
    if (v.quantity != "displacement") continue;
    theory.x.push_back(v.time);
    theory.y.push_back(v.expected);
  }
  curves.push_back(std::move(theory));
  return report::run_picture({comparison.name,
                              shown->start,
                              shown->end,
                              curves,
                              {"time [s]", fmt::format("displacement of block {} [m]", shown->followed_block)},
                              "s"});
}

/// A case file that cannot be read is reported when the case is run.
bool is_slow(const CaseFolder& folder) {
  try {
    return read_case_file(folder).is_slow;
  } catch (const std::exception&) {
    return false;
  }
}

/// Results of all cases and traces, and the names of cases that could not be run.
struct Comparison {
  std::vector<CaseComparison> cases;
  std::vector<TraceDifference> traces;
  std::vector<std::string> refused;
  std::size_t slow = 0;  ///< skipped cases

  /// Reruns one folder. A case that cannot be read is reported and counted; the others continue.
  void add(const CaseFolder& folder, const CompareOptions& options) {
    try {
      if (folder.has_expected) cases.push_back(study::compare_in(folder, options.profiles()));
      if (folder.has_trace) traces.push_back(study::follow_trace(folder));
    } catch (const std::exception& error) {
      spdlog::error("{}: {}", folder.name, error.what());
      refused.push_back(folder.name);
    }
  }

  /// Returns the names of rejected cases and of those that do not hold.
  std::vector<std::string> missed() const {
    std::vector<std::string> names = refused;
    for (const CaseComparison& c : cases)
      if (!c.holds()) names.push_back(c.name);
    for (const TraceDifference& t : traces)
      if (!t.holds()) names.push_back(t.name);
    return names;
  }

  /// Counts the misses of all runs.
  std::size_t listed_misses() const {
    std::size_t count = 0;
    for (const CaseComparison& c : cases)
      for (const auto* runs : {&c.plain, &c.variants})
        for (const ComparedCase& run : *runs)
          count += static_cast<std::size_t>(std::ranges::count_if(run.values, &ComparedValue::is_listed_miss));
    return count;
  }
};

void print_json(const Comparison& all) {
  Json json = {{"cases", Json::array()}, {"traces", Json::array()}, {"refused", all.refused}, {"slow", all.slow}};
  for (const CaseComparison& c : all.cases) json["cases"].push_back(json_of(c));
  for (const TraceDifference& t : all.traces) json["traces"].push_back(json_of(t));
  fmt::print("{}\n", json.dump(1));
}

ExitCode verdict(const Comparison& all) {
  const std::vector<std::string> missed = all.missed();
  const std::size_t listed = all.listed_misses();
  spdlog::info("{}, {}, {} missed{}{}", counted(all.cases.size(), "case"), counted(all.traces.size(), "trace"),
               missed.size(), listed == 0 ? "" : fmt::format("; {} listed as missed", counted(listed, "value")),
               all.slow == 0 ? "" : fmt::format("; {} left out (--all runs them)", counted(all.slow, "slow case")));
  if (!missed.empty()) spdlog::info("missed: {}", fmt::join(missed, ", "));
  if (all.cases.empty() && all.traces.empty()) return all.slow == 0 ? ExitCode::unreadable : ExitCode::usage;
  return missed.empty() ? ExitCode::ok : ExitCode::check_failed;
}

ExitCode compare(const CompareOptions& options) {
  Comparison all;
  const std::vector<CaseFolder> folders = find_cases(options.cases);
  const auto with_values = std::ranges::count_if(folders, &CaseFolder::has_expected);
  if (!options.picture.empty() && with_values != 1)
    throw UsageError(fmt::format("--picture: expected one case with expected values, found {}", with_values));
  std::vector<std::filesystem::path> inputs;
  for (const CaseFolder& folder : folders) inputs.emplace_back(folder.folder);
  require_picture_name("--picture", options.picture);
  require_writable({options.picture}, inputs, overwrite_if(options.force));
  // If all cases are slow, the user requested them by name.
  const bool only_slow = std::ranges::all_of(folders, [](const CaseFolder& f) { return is_slow(f); });
  for (const CaseFolder& folder : folders) {
    const std::size_t before = all.cases.size();
    if (!options.with_slow && !only_slow && is_slow(folder)) {
      ++all.slow;
      continue;
    }
    all.add(folder, options);
    if (all.cases.size() == before || options.as_json) continue;
    fmt::print("{}", table_of(all.cases.back(), options.with_sources ? Detail::full : Detail::brief));
    std::fflush(stdout);
  }
  if (!options.picture.empty()) {
    if (all.cases.size() != 1) throw UsageError("--picture: the case was not run");
    write_picture(options.picture, picture_of(all.cases.front()), overwrite_if(options.force));
  }
  if (options.as_json)
    print_json(all);
  else
    fmt::print("{}", table_of(all.traces));
  std::fflush(stdout);  // prints the table before the verdict, for any two streams
  return verdict(all);
}

}  // namespace

Action configure_compare(CLI::App& options) {
  const auto chosen = std::make_shared<CompareOptions>();
  options.add_option("cases", chosen->cases, "case folders, or folders of cases")->capture_default_str();
  options
      .add_option("--profile", chosen->profile,
                  "run only this profile (default: legacy and standard, whose tolerances the others share); traces are "
                  "those of legacy")
      ->check(one_word_of(profile_names()));
  add_thread_option(options);
  options.add_flag("--all", chosen->with_slow, "run slow cases too");
  options.add_option("--picture", chosen->picture, "write a picture (SVG), if one case is given")->type_name("FILE");
  options.add_flag("--force", chosen->force, "overwrite the picture if it exists");
  options.add_flag("--sources", chosen->with_sources, "print the reasons of the tolerances");
  options.add_flag("--json", chosen->as_json, "print the tables as JSON");
  return [chosen] { return compare(*chosen); };
}

}  // namespace keyblock
