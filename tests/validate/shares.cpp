// Computes sums, worst values and their tables.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/validate/shares.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

namespace keyblock {
namespace {

constexpr double kShareAsked = 0.999;
// Residuals over the largest load on a block: the goal of a step, and the value that a step may accept where the goal
// is out of reach.
constexpr double kResidualAsked = 1e-6;
constexpr double kResidualAccepted = 1e-4;
// Contact forces are known to kResidualAsked: over the travel of a step that is their possible error of energy.
constexpr double kEnergyAsked = 1e-6;
// The requirement is 1e-3 of the present area; soft rock that exceeds it under its neighbours is elastic. The part that
// no stress explains must be far below it.
constexpr double kFalseAreaAsked = 1e-6;
// Springs of the modulus press the blocks of a slope together by a hundredth of this; a block that penetrates takes
// more.
constexpr double kOverlapAsked = 1e-3;

Share sum(const std::string& kind, const std::string& profile, const std::vector<const SceneRun*>& runs) {
  Share s{kind, profile};
  std::vector<double> residuals;
  long made = 0;
  long passes = 0;
  for (const SceneRun* run : runs) {
    ++s.scenes;
    s.refused += run->end == End::refused ? 1 : 0;
    s.failed += run->end == End::failed ? 1 : 0;
    s.crashed += run->end == End::crashed ? 1 : 0;
    s.silent += run->end != End::finished && run->reason.empty() ? 1 : 0;
    s.asked += run->asked;
    s.plain += run->plain;
    s.with_fallback += run->with_fallback;
    s.cut += run->cut;
    s.unsettled += run->unsettled;
    made += run->made;
    passes += run->passes;
    residuals.insert(residuals.end(), run->residuals.begin(), run->residuals.end());
    s.energy_gain = std::max(s.energy_gain, run->energy_gain);
    s.energy_excess = std::max(s.energy_excess, run->energy_excess);
    s.rise = std::max(s.rise, run->rise);
    s.area_change = std::max(s.area_change, run->area_change);
    s.false_area_change = std::max(s.false_area_change, run->false_area_change);
    s.overlap = std::max(s.overlap, run->overlap);
    s.seconds += run->seconds;
  }
  s.passes = made == 0 ? 0 : static_cast<double>(passes) / static_cast<double>(made);
  if (residuals.empty()) return s;
  const auto middle = residuals.begin() + static_cast<std::ptrdiff_t>(residuals.size() / 2);
  std::ranges::nth_element(residuals, middle);
  s.median_residual = *middle;
  s.greatest_residual = std::ranges::max(residuals);
  s.above_goal = std::ranges::count_if(residuals, [](double residual) { return residual > kResidualAsked; });
  return s;
}

std::string_view word_for(End end) {
  switch (end) {
    case End::finished:
      return "finished";
    case End::refused:
      return "refused";
    case End::failed:
      return "failed";
    case End::crashed:
      return "crashed";
  }
  return "crashed";
}

}  // namespace

std::vector<Share> shares_of(const std::vector<SceneRun>& runs) {
  std::map<std::pair<std::string, std::string>, std::vector<const SceneRun*>> groups;
  for (const SceneRun& run : runs) {
    groups[{run.scene.substr(0, run.scene.find(' ')), run.profile}].push_back(&run);
    groups[{"all", run.profile}].push_back(&run);
  }
  std::vector<Share> shares;
  for (const auto& [key, group] : groups) shares.push_back(sum(key.first, key.second, group));
  return shares;
}

std::string shares_csv(const std::vector<Share>& shares) {
  std::string table =
      "kind,profile,scenes,refused,failed,crashed,steps_asked,converged,by_newton_alone,with_fallback,cut,unsettled,"
      "passes_per_step,median_residual,greatest_residual,energy_gain,kinetic_above_released,rise,area_change,false_"
      "area_change,overlap\n";
  for (const Share& s : shares)
    table += fmt::format(
        "{},{},{},{},{},{},{},{:.5f},{:.5f},{},{},{},{:.2f},{:.1e},{:.1e},{:.1e},{:.1e},{:.1e},{:.1e},{:.1e},{:.1e}\n",
        s.kind, s.profile, s.scenes, s.refused, s.failed, s.crashed, s.asked, s.converged(), s.by_newton(),
        s.with_fallback, s.cut, s.unsettled, s.passes, s.median_residual, s.greatest_residual, s.energy_gain,
        s.energy_excess, s.rise, s.area_change, s.false_area_change, s.overlap);
  return table;
}

std::string ended_csv(const std::vector<SceneRun>& runs) {
  std::string table = "scene,profile,blocks,dt,steps_made,end,reason\n";
  for (const SceneRun& run : runs) {
    if (run.end == End::finished) continue;
    std::string reason = run.reason;
    std::ranges::replace(reason, '"', '\'');
    table += fmt::format("{},{},{},{},{},{},\"{}\"\n", run.scene, run.profile, run.blocks, run.time_step, run.made,
                         word_for(run.end), reason);
  }
  return table;
}

std::string reasons_csv(const std::vector<SceneRun>& runs) {
  std::map<std::pair<std::string, std::string>, int> counts;
  for (const SceneRun& run : runs) {
    if (run.end == End::finished) continue;
    const std::size_t place = run.reason.starts_with("step ") ? run.reason.find("): ") : std::string::npos;
    const std::string sentence = place == std::string::npos ? run.reason : run.reason.substr(place + 3);
    ++counts[{run.profile, fmt::format("{},\"{}\"", word_for(run.end), sentence.substr(0, sentence.find(';')))}];
  }
  std::string table = "profile,end,reason,runs\n";
  for (const auto& [key, count] : counts) table += fmt::format("{},{},{}\n", key.first, key.second, count);
  return table;
}

std::string runs_csv(const std::vector<SceneRun>& runs) {
  std::string table =
      "scene,profile,blocks,dt,steps_made,by_newton_alone,with_fallback,cut,passes,greatest_residual,energy_gain,"
      "kinetic_above_released,rise,area_change,seconds\n";
  for (const SceneRun& run : runs)
    table += fmt::format("{},{},{},{},{},{},{},{},{},{:.1e},{:.1e},{:.1e},{:.1e},{:.1e},{:.2f}\n", run.scene,
                         run.profile, run.blocks, run.time_step, run.made, run.plain, run.with_fallback, run.cut,
                         run.passes, run.residuals.empty() ? 0 : std::ranges::max(run.residuals), run.energy_gain,
                         run.energy_excess, run.rise, run.area_change, run.seconds);
  return table;
}

std::vector<std::string> misses_of_standard(const std::vector<Share>& shares) {
  std::vector<std::string> misses;
  const auto ask = [&](const Share& s, const char* what, double got, double most) {
    if (!(got <= most))
      misses.push_back(fmt::format("{}: {} is {:.2g}, asked at most {:.2g}", s.kind, what, got, most));
  };
  for (const Share& s : shares) {
    if (s.profile != "standard") continue;
    ask(s, "share of steps that did not converge without cutting", 1 - s.converged(), 1 - kShareAsked);
    ask(s, "share of steps whose residual is above 1e-6 of the largest load",
        s.asked == 0 ? 0 : static_cast<double>(s.above_goal) / static_cast<double>(s.asked), 1 - kShareAsked);
    ask(s, "greatest residual over the largest load", s.greatest_residual, kResidualAccepted);
    ask(s, "number of crashes and of ends without a reason", s.crashed + s.silent, 0);
    ask(s, "gain of energy over m g h", s.energy_gain, kEnergyAsked);
    ask(s, "kinetic above released potential energy, over m g h", s.energy_excess, kEnergyAsked);
    ask(s, "rise of the centre of mass over the height", s.rise, kEnergyAsked);
    ask(s, "area that blocks share over theirs", s.overlap, kOverlapAsked);
    ask(s, "change of area that no stress explains", s.false_area_change, kFalseAreaAsked);
  }
  return misses;
}

}  // namespace keyblock
