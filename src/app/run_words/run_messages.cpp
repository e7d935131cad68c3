// Prints by level: errors always, help and summary unless --quiet, solver statistics with --verbose.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/run_words/run_messages.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <vector>

#include "app/messages.hpp"
#include "app/run_words/first_line.hpp"
#include "app/run_words/summary.hpp"
#include "app/stop_request.hpp"
#include "base/counted.hpp"
#include "base/words/diagnostics.hpp"
#include "cut/bodies/slivers.hpp"
#include "geometry/polygon.hpp"

namespace keyblock {
namespace {

void print_help(std::string_view words) {
  spdlog::info("{}", help_line(words));
}

std::string blocks_in_words(const std::vector<int>& numbers) {
  return fmt::format("block{} {}", numbers.size() == 1 ? "" : "s", fmt::join(numbers, ", "));
}

// If a sliver falls, statics shows no result for the other blocks.
bool only_slivers_move(const Prepared& prepared, const RunOutcome& outcome) {
  const std::vector<BlockPolygon>& blocks = prepared.blocks.blocks;
  if (!is_of_the_scene(outcome.failure) || outcome.numbers.empty() || !outcome.scenes.empty()) return false;
  const double mean = prepared.scene.model.mean_area;
  return std::ranges::all_of(outcome.numbers, [&](int number) {
    const auto at = static_cast<std::size_t>(number) - 1;
    return at < blocks.size() && is_sliver(form_of(blocks[at]), mean);
  });
}

std::string stopped_how() {
  return is_at_time_limit() ? "stopped at the limit of processor time" : "stopped by request";
}

void print_how_to_resume(const std::string& folder) {
  print_help(fmt::format("keyblock run --resume {} continues it", folder));
}

// Returns those of `names` that the run wrote, with their folder.
template <std::size_t N>
std::vector<std::string> written(const RunRecord& record, const std::string& folder,
                                 const std::array<std::string_view, N>& names) {
  std::vector<std::string> files;
  for (const std::string_view name : names)
    if (std::ranges::find(record.outputs, name) != record.outputs.end())
      files.push_back((std::filesystem::path(folder) / name).string());
  return files;
}

void print_files(const RunRecord& record, const std::string& folder) {
  std::vector<std::string> views =
      written(record, folder,
              std::array<std::string_view, 6>{"page.html", "picture.svg", "field.svg", "energy.svg", "plastic.svg",
                                              "reactions.svg"});
  const auto picture =
      std::ranges::find_if(views, [](const std::string& file) { return file.ends_with("picture.svg"); });
  if (picture != views.end() && record.outcome.end == RunEnd::failed && !record.outcome.numbers.empty())
    *picture += fmt::format(" ({} {} marked)", blocks_in_words(record.outcome.numbers),
                            record.outcome.numbers.size() == 1 ? "is" : "are");
  for (const std::string& fields : written(record, folder, std::array<std::string_view, 1>{"fields.pvd"}))
    views.push_back(fields + " (ParaView)");
  if (!views.empty()) spdlog::info("open {}", fmt::join(views, ", "));
  const std::vector<std::string> tables = written(
      record, folder,
      std::array<std::string_view, 5>{"history.csv", "histories.csv", "contacts.csv", "bolts.csv", "ledger.csv"});
  const std::string json = (std::filesystem::path(folder) / "run.json").string();
  if (tables.empty())
    spdlog::info("record {}", json);
  else
    spdlog::info("data {}; record {}", fmt::join(tables, ", "), json);
}

}  // namespace

void RunMessages::print_start(const std::string& file, const Prepared& prepared, const RunRecord& record) {
  file_ = file;
  spdlog::info("{}", first_line(file, prepared, record));
  spdlog::debug("profile: {}, because {}", record.profile, record.profile_because);
  spdlog::debug("read in {:.3g} s, prepared in {:.3g} s; one frame per {}", record.timings.read, record.timings.prepare,
                counted(static_cast<std::size_t>(record.record_every), "step"));
  print_warnings(record, false);
}

void RunMessages::print_resumed(std::optional<int> step) const {
  if (step)
    spdlog::info("continuing after step {}", *step);
  else
    spdlog::info("no checkpoint was saved; starting again from step 1");
}

void RunMessages::print_stopped_early(const std::string& folder) const {
  spdlog::warn("{}: {} before the first step", file_, stopped_how());
  print_how_to_resume(folder);
}

// Doubts are printed as errors at the end.
void RunMessages::print_warnings(const RunRecord& record, bool with_notes) {
  const bool is_verbose = spdlog::should_log(spdlog::level::debug);
  Warnings now;
  for (const Warning& warning : record.warnings) {
    const bool is_doubt = std::ranges::find(record.doubts, warning.name, &Warning::name) != record.doubts.end();
    const bool waits = !is_verbose && !with_notes && level_of(warning.name) == DiagnosticLevel::note;
    if (is_doubt || waits || !printed_.insert(to_string(warning)).second) continue;
    now.push_back(warning);
  }
  log_by_level(now, "the case");
}

void RunMessages::print_failure(const Prepared& prepared, const RunOutcome& outcome) const {
  spdlog::error("{}: error: {}", file_, outcome.reason);
  if (only_slivers_move(prepared, outcome))
    print_help(fmt::format("only slivers move ({}): --set slivers=glue merges them, slivers=leave_out deletes them",
                           blocks_in_words(outcome.numbers)));
  std::vector<std::string> ways;
  for (const Remedy& remedy : what_to_try(prepared, outcome))
    ways.push_back(fmt::format("{} {}", remedy.option, remedy.what));
  if (!ways.empty() && outcome.failure == FailureKind::accelerates && prepared.scene.growth == nullptr)
    ways.push_back(fmt::format("keyblock fos {} computes the factor of safety", file_));
  if (!ways.empty()) print_help(fmt::format("{}", fmt::join(ways, "; ")));
}

void RunMessages::print_doubts(const Warnings& doubts) const {
  for (std::size_t i = 0; i < doubts.size(); ++i) {
    spdlog::error("{}: error: {}{} [{}]", file_,
                  i == 0 ? "the run finished, but its results are unreliable: " : "also unreliable: ",
                  doubts[i].sentence, doubts[i].name);
    const bool is_last_of_code = i + 1 == doubts.size() || doubts[i + 1].name != doubts[i].name;
    const Diagnostic* known = find_diagnostic(doubts[i].name);
    if (is_last_of_code && known != nullptr && !known->remedy.empty()) print_help(known->remedy);
  }
}

void RunMessages::print_stop(int steps, const std::string& folder) const {
  spdlog::warn("{}: {} after {}", file_, stopped_how(), counted(static_cast<std::size_t>(steps), "step"));
  print_how_to_resume(folder);
}

void RunMessages::print_end(const Prepared& prepared, const RunRecord& record, const std::string& folder) {
  const RunOutcome& outcome = record.outcome;
  print_warnings(record, true);
  if (outcome.end == RunEnd::failed) print_failure(prepared, outcome);
  if (outcome.end == RunEnd::stopped && outcome.why_early.empty()) print_stop(outcome.steps, folder);
  if (outcome.end == RunEnd::stopped && !outcome.why_early.empty()) {
    spdlog::info("{}: stopped after {}: {}", file_, counted(static_cast<std::size_t>(outcome.steps), "step"),
                 outcome.why_early);
    print_how_to_resume(folder);
  }
  if (!outcome.start.balanced.empty()) spdlog::debug("initial state: {}", outcome.start.balanced);
  if (record.totals.steps > 0) spdlog::debug("{}", solver_in_words(prepared.scene.settings, record.totals));
  spdlog::info("{}", end_in_words(record));
  for (const std::string& row : summary_rows(prepared, record)) spdlog::info("{}", row);
  if (outcome.end == RunEnd::finished) print_doubts(record.doubts);
  print_files(record, folder);
}

}  // namespace keyblock
