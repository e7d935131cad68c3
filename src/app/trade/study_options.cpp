// Checks outputs and references before the runs, which may take minutes.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/trade/study_options.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <thread>

#include "app/input/case_options.hpp"
#include "app/option_checks.hpp"
#include "app/stop_request.hpp"
#include "base/error.hpp"
#include "job/files.hpp"
#include "settings/profile.hpp"

namespace keyblock {

using Json = nlohmann::ordered_json;

namespace {

double load_average() {
  double load = std::nan("");
  return getloadavg(&load, 1) == 1 ? load : std::nan("");
}

}  // namespace

study::RunLimits StudyOptions::limits() const {
  return {repeat, limit};
}

void add_study_options(CLI::App& options, StudyOptions& chosen) {
  options.add_option("case", chosen.paths, "one case folder, or the files of a case")->required();
  options.add_option("--profile", chosen.profile, "preset from which the runs differ (default: standard)")
      ->check(one_word_of(profile_names()));
  options.add_option("--set", chosen.sets, "change one setting of all runs; may be repeated")
      ->type_name("KEY=VALUE")
      ->take_all();
  options
      .add_option(
          "--against", chosen.against,
          "reference for errors: expected (values of expected.csv; default if there are any) or finest (limit of "
          "runs with ever smaller steps)")
      ->check(one_word_of({"expected", "finest"}));
  options
      .add_option("--finest", chosen.finest,
                  "smallest step of the reference: 1/N of the step, N = 4 (default), 8, 16, …")
      ->check(CLI::Range(4, 1024));
  options.add_option("--repeat", chosen.repeat, "time each run N times and take the shortest (default: 1)")
      ->check(CLI::Range(1, 1000));
  options.add_option("--limit", chosen.limit, "processor time per run, seconds (default: 60)")->check(above_zero());
  options.add_option("--picture", chosen.picture, "write a picture (SVG)")->type_name("FILE");
  options.add_flag("--json", chosen.as_json, "print the table as JSON");
  options.add_flag("--force", chosen.force, "overwrite files");
}

study::StudyCase case_asked(const StudyOptions& options) {
  if (!std::has_single_bit(static_cast<unsigned>(options.finest)))
    throw UsageError(fmt::format("--finest: expected a power of two, found {}", options.finest));
  study::StudyCase chosen = study::study_case(options.paths);
  chosen.common = overrides_of(options.sets);
  if (options.against == "expected" && chosen.expected.empty())
    throw UsageError(fmt::format("--against expected: {} has no expected.csv", chosen.name));
  if (options.against == "finest") chosen.expected.clear();
  if (!options.against.empty()) return chosen;
  const std::size_t given = chosen.expected.size();
  chosen.expected = study::without_verdicts(std::move(chosen.expected));
  if (given > 0 && chosen.expected.empty())
    spdlog::info("expected.csv only states whether something happens: errors are against the finest runs");
  return chosen;
}

void tell_run(const study::MeasuredRun& run, std::size_t done, std::size_t of) {
  if (run.end == study::MeasuredEnd::finished)
    spdlog::info("{} of {}: {}, {:.3g} s", done, of, run.plan.name, run.seconds);
  else
    spdlog::info("{} of {}: {}, {}: {}", done, of, run.plan.name, name_of(run.end), run.reason);
}

ExitCode stopped_with(const study::Tradeoff& result) {
  const auto made = std::ranges::count_if(
      result.runs, [](const study::MeasuredRun& run) { return run.end != study::MeasuredEnd::stopped; });
  spdlog::warn("stopped {}; {} of {} runs were made",
               is_at_time_limit() ? "at the limit of processor time" : "by request", made, result.runs.size());
  return is_at_time_limit() ? ExitCode::limit : ExitCode::stopped;
}

std::string machine_words() {
  return fmt::format("{} processors, load {:.1f} at the end", std::thread::hardware_concurrency(), load_average());
}

Json json_number(double value) {
  return std::isfinite(value) ? Json(value) : Json();
}

bool is_in_doubt_as_a_whole(const study::Reference& reference) {
  constexpr double kOfUse = 0.1;
  return reference.guessed_below() > kOfUse;
}

std::string words_of_doubt(const study::Reference& reference) {
  if (reference.values.empty()) return reference.doubt;
  return fmt::format("not resolved: {}, so that errors below {:.1e} are a guess", reference.doubt,
                     reference.guessed_below());
}

std::string reference_words(const study::Reference& reference) {
  if (reference.is_resolved()) return reference.words;
  return fmt::format("{}; {}", reference.words, words_of_doubt(reference));
}

Json reference_json(const study::Reference& reference) {
  return {{"kind", reference.is_expected ? "expected" : "finest"},
          {"extrapolated", reference.is_extrapolated},
          {"observed_order", reference.order ? json_number(*reference.order) : Json()},
          {"uncertainty", reference.uncertainty},
          {"resolved", reference.is_resolved()},
          {"doubt", reference.doubt},
          {"guessed_below", reference.guessed_below()},
          {"words", reference.words}};
}

Json settings_json(const std::vector<Override>& settings) {
  Json json = Json::object();
  for (const auto& [name, value] : settings) json[name] = value;
  return json;
}

Json machine_json() {
  return {{"processors", std::thread::hardware_concurrency()}, {"load", json_number(load_average())}};
}

}  // namespace keyblock
