// Table of step warnings: for each kind of step, its condition and its values.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/run_warnings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "base/sentences/sentences.hpp"
#include "base/words/quoted_name.hpp"
#include "model/material_choices.hpp"
#include "result/describe.hpp"

namespace keyblock {
namespace {

// Penetrations above this many times the allowed one no longer look like contact.
constexpr double kDeepPenetrations = 10;
// A sound system is solved to 1e-12 or better; above this a penalty is too great for double precision.
constexpr double kLargeResidual = 1e-9;
// Contact forces of dynamics `standard` are solved at least to this fraction of the load; up to `kLargeImbalance` a
// larger one does not matter.
constexpr double kImbalance = 1e-6;
constexpr double kLargeImbalance = 1e-4;
// An initial state that leaves more than this fraction of its gaps differs from the requested one.
constexpr double kLargeMisfit = 1e-6;
// A load step that needs this many parts adds little load, or failing rock unloads in it.
constexpr int kManyParts = 4;
// A step below this fraction of the way before it is round-off: it need not shrink any more.
constexpr double kNoStep = 1e-9;

std::vector<Finding> start_complaints(const StartReport& start) {
  std::vector<Finding> found;
  if (!start.why.empty())
    found.push_back({"start_settled:one_of_several", {{}, {{"made", start.made}, {"why", start.why}}}});
  if (start.misfit > kLargeMisfit) found.push_back({"start_settled:gaps_left", {{{"misfit", start.misfit}}}});
  if (start.unsolved_steps > 0) found.push_back({"start_settled:no_forces", {{{"steps", start.unsolved_steps}}}});
  return found;
}

/// Limits that the steps of a run are compared with.
struct StepLimits {
  double time_step = 0;  ///< the shortest of the scenes
  double longest_step = 0;
  bool constant = true;
  bool cut_stays = false;
  bool is_standard = true;
  bool is_moving = true;  ///< dynamic, under `standard`
  bool searches_pairs = true;
  const char* noun = "block";
  double allowed = 0;     ///< displacement of a step
  double block_size = 0;  ///< of the mean block
  double deep = 0;        ///< penetration
};

StepLimits limits_of(const Scene& first, bool balances) {
  const Settings& settings = first.settings;
  const Model& model = first.model;
  const auto time_step_of = [](const Scene* scene) { return scene->settings.time_step; };
  const std::vector<const Scene*> scenes = scenes_of(first);
  StepLimits limits;
  limits.time_step = time_step_of(std::ranges::min(scenes, {}, time_step_of));
  limits.longest_step = time_step_of(std::ranges::max(scenes, {}, time_step_of));
  limits.constant = settings.step_control == StepControl::constant;
  limits.cut_stays = settings.quirks.cut_step_stays;
  limits.is_standard = settings.dynamics == Dynamics::standard;
  limits.is_moving = limits.is_standard && settings.standard.motion == MotionRule::dynamic;
  limits.noun = model.nodes.empty() ? "block" : "element";
  limits.searches_pairs = model.nodes.empty() && model.elements.size() > 1 && !balances;
  limits.allowed = settings.allowed_displacement_ratio * model.scale;
  limits.block_size = std::sqrt(model.mean_area);
  limits.deep = kDeepPenetrations * settings.open_close.allowed_penetration * model.scale;
  return limits;
}

/// Returns the kinds of steps that are cut, or too long for the motion.
std::vector<StepKind> kinds_by_length(const StepLimits& l) {
  return {
      {"step_cut", [l](const StepReport& s) { return l.constant && s.dt < l.time_step; },
       [l](const StepReport& s, Facts& facts) {
         facts.numbers.insert(facts.numbers.end(), {{"time_step", l.time_step}, {"dt", s.dt}});
         return l.cut_stays ? "step_cut:stays" : "step_cut";
       }},
      {"step_moves_far", [l](const StepReport& s) { return l.is_moving && l.constant && s.displacement_ratio > 1; },
       [](const StepReport& s, Facts& facts) {
         facts.numbers.emplace_back("ratio", s.displacement_ratio);
         return "step_moves_far";
       }},
      {"step_passes_blocks",
       [l](const StepReport& s) { return l.searches_pairs && s.displacement_ratio * l.allowed > l.block_size; },
       [l](const StepReport& s, Facts& facts) {
         facts.numbers.insert(facts.numbers.end(),
                              {{"displacement", s.displacement_ratio * l.allowed}, {"width", l.block_size}});
         return "step_passes_blocks";
       }},
      {"step_above_limit", [l](const StepReport& s) { return !l.constant && s.dt > l.longest_step; },
       [l](const StepReport& s, Facts& facts) {
         facts.numbers.insert(facts.numbers.end(), {{"dt", s.dt}, {"limit", l.longest_step}});
         return "step_above_limit";
       }},
      {"step_unresolved", [](const StepReport& s) { return s.unresolved_parts > 0; },
       [](const StepReport& s, Facts& facts) {
         facts.numbers.emplace_back("parts", s.unresolved_parts);
         return "step_unresolved";
       }},
  };
}

void put_imbalance(const StepLimits& l, const StepReport& s, double limit, Facts& facts) {
  facts.numbers.insert(facts.numbers.end(), {{"tolerance", limit}, {"residual", s.residual}});
  if (s.residual_element == 0) return;
  facts.numbers.insert(facts.numbers.end(), {{"contacts", s.contacts}, {"closed", s.closed}});
  facts.texts.emplace_back("noun", l.noun);
  facts.elements = {s.residual_element, s.residual_other};
  facts.points = {{s.residual_at.x, s.residual_at.y}};
}

/// Returns the kinds of steps whose forces or equations are not solved well enough.
std::vector<StepKind> kinds_by_residual(const StepLimits& l) {
  return {
      {"residual_above_goal",
       [l](const StepReport& s) { return l.is_standard && s.residual > kImbalance && s.residual <= kLargeImbalance; },
       [l](const StepReport& s, Facts& facts) {
         put_imbalance(l, s, kImbalance, facts);
         return "residual_above_goal";
       },
       [](const StepReport& s) { return s.residual; }},
      {"large_residual",
       [l](const StepReport& s) { return s.residual > (l.is_standard ? kLargeImbalance : kLargeResidual); },
       [l](const StepReport& s, Facts& facts) {
         put_imbalance(l, s, l.is_standard ? kLargeImbalance : kLargeResidual, facts);
         return l.is_standard ? "large_residual:of_forces" : "large_residual";
       },
       [](const StepReport& s) { return s.residual; }},
  };
}

/// Returns the kinds of steps whose contacts are not solved well enough, or that needed parts.
std::vector<StepKind> kinds_by_contacts(const StepLimits& l) {
  return {
      {"unsettled_step_accepted", [](const StepReport& s) { return s.unsettled_contacts > 0; },
       [](const StepReport& s, Facts& facts) {
         facts.numbers.emplace_back("contacts", s.unsettled_contacts);
         return "unsettled_step_accepted";
       }},
      {"deep_penetration", [l](const StepReport& s) { return s.greatest_penetration > l.deep; },
       [l](const StepReport& s, Facts& facts) {
         facts.numbers.insert(facts.numbers.end(),
                              {{"penetration", s.greatest_penetration},
                               {"times_allowed", kDeepPenetrations * s.greatest_penetration / l.deep}});
         return "deep_penetration";
       }},
  };
}

std::vector<StepKind> kinds_by_parts() {
  return {
      {"step_in_parts", [](const StepReport& s) { return s.parts >= kManyParts; },
       [](const StepReport& s, Facts& facts) {
         facts.numbers.emplace_back("parts", s.parts);
         return "step_in_parts";
       }},
      {"overlaps_locked", [](const StepReport& s) { return s.locked_overlaps > 0; },
       [](const StepReport& s, Facts& facts) {
         facts.numbers.emplace_back("overlaps", s.locked_overlaps);
         return "overlaps_locked";
       }},
  };
}

}  // namespace

StepWatch::StepWatch(const Prepared& prepared) {
  const Settings& settings = prepared.scene.settings;
  const Model& model = prepared.scene.model;
  const bool is_old = settings.dynamics == Dynamics::shi;
  // If points are driven, each step has another equilibrium.
  const bool stands_still =
      std::ranges::all_of(model.fixed_points, [](const CarriedPoint& point) { return point.curve.times.size() < 2; });
  const std::vector<const Scene*> scenes = scenes_of(prepared.scene);
  creeps_ = scenes.size() == 1 && keyblock::is_static(settings, model) && !model.nodes.empty() &&
            (is_old || (settings.standard.motion == MotionRule::dynamic && stands_still));
  const auto balances = [](const Scene* scene) {
    return scene->settings.dynamics == Dynamics::standard && scene->settings.standard.motion != MotionRule::dynamic;
  };
  balances_ = std::ranges::all_of(scenes, balances);
  is_static_ = std::ranges::all_of(scenes, [&](const Scene* scene) {
    return balances(scene) || keyblock::is_static(scene->settings, scene->model);
  });
  const StepLimits limits = limits_of(prepared.scene, balances_);
  for (const std::vector<StepKind>& kinds :
       {kinds_by_length(limits), kinds_by_contacts(limits), kinds_by_residual(limits), kinds_by_parts()})
    kinds_.insert(kinds_.end(), kinds.begin(), kinds.end());
  seen_.resize(kinds_.size());
}

void StepWatch::add(const StepReport& step) {
  ++steps_;
  way_ += step.displacement_ratio;
  before_ = std::exchange(last_, step.displacement_ratio);
  for (std::size_t i = 0; i < kinds_.size(); ++i) {
    const StepKind& kind = kinds_[i];
    if (!kind.concerns(step)) continue;
    const bool is_told = seen_[i].count++ == 0 || (kind.measure && kind.measure(step) > kind.measure(seen_[i].told));
    if (is_told) seen_[i].told = step;
  }
}

void StepWatch::describe(Archive& archive) {
  archive.value("steps", steps_);
  archive.value("way", way_);
  archive.value("before", before_);
  archive.value("last", last_);
  archive.group("blocks", [&] { blocks_.describe(archive); });
  archive.table("kinds", seen_, [&](Seen& seen) {
    keyblock::describe(archive, seen.told);
    archive.value("concerned", seen.count);
  });
}

Warnings StepWatch::warnings(const Place& place) const {
  Warnings warnings;
  for (std::size_t i = 0; i < kinds_.size(); ++i) {
    const auto& [step, count] = seen_[i];
    if (count == 0) continue;
    Facts facts{{{"step", step.step}, {"time", step.time}, {"concerned", count}, {"steps", steps_}}};
    const char* const form = kinds_[i].describe(step, facts);
    warnings.push_back(warning_of({form, std::move(facts)}, place));
  }
  return joined(std::move(warnings), far_from_equilibrium(place));
}

// Each step leaves the fraction p = 1 / (1 + (ω dt)²/2) of a mode of frequency ω. Steps shrink by p, and the sum of the
// remaining ones is the last times p / (1 - p).
std::optional<EquilibriumWay> StepWatch::equilibrium_way() const {
  if (balances_ && steps_ > 0) return EquilibriumWay{1, 0};
  if (!creeps_ || steps_ < 2 || way_ == 0) return std::nullopt;
  const double shrinking = before_ > 0 ? last_ / before_ : 1;
  if (last_ < kNoStep * way_) return EquilibriumWay{1, shrinking};
  if (shrinking >= 1) return EquilibriumWay{std::nullopt, shrinking};
  return EquilibriumWay{way_ / (way_ + last_ * shrinking / (1 - shrinking)), shrinking};
}

Warnings StepWatch::far_from_equilibrium(const Place& place) const {
  const std::optional<EquilibriumWay> way = equilibrium_way();
  if (!way || way->share.value_or(0) > kNearEquilibrium) return {};
  Facts facts{{{"steps", steps_}, {"ratio", way->last_step_ratio}}};
  if (way->share) facts.numbers.emplace_back("percent", 100 * *way->share);
  const char* const form = way->share ? "far_from_equilibrium" : "far_from_equilibrium:no_sign";
  return {warning_of({form, std::move(facts)}, place)};
}

Warnings outcome_warnings(const Prepared& prepared, const RunOutcome& outcome, const Place& place) {
  Warnings warnings;
  for (Finding& found : start_complaints(outcome.start)) warnings.push_back(warning_of(std::move(found), place));
  if (!outcome.start.unbalanced.empty())
    warnings.push_back(warning_of({"start_without_rest", {{}, {{"why", outcome.start.unbalanced}}}}, place));
  const auto warn_held = [&](const char* after, const char* before, const TimeCurve& curve) {
    if (curve.times.empty()) return;
    if (curve.times.back() < outcome.time && curve.values.back() != Point{})
      warnings.push_back(
          warning_of({after, {{{"table_end", curve.times.back()}, {"time", outcome.time}}}}, curve.place));
    if (curve.times.size() > 1 && curve.times.front() > 0 && curve.values.front() != Point{})
      warnings.push_back(warning_of({before, {{{"table_start", curve.times.front()}}}}, curve.place));
  };
  if (prepared.scene.settings.ledger == Bookkeeping::off && !prepared.scene.is_untouched)
    warnings.push_back(warning_of({"energy_not_judged"}, place));
  for (const CarriedPoint& point : prepared.scene.model.loading_points)
    warn_held("load_held_after_table", "load_held_before_table", point.curve);
  warn_held("acceleration_held_after_table", "acceleration_held_before_table",
            prepared.scene.settings.body_acceleration.curve);
  return warnings;
}

Warnings broken_bolts(const Frame& first, const Frame& last, const Place& place) {
  const auto numbers_of_broken = [](const Frame& frame) {
    std::map<int, std::string> names;
    for (std::size_t i = 0; i < frame.bolts.size(); ++i)
      if (const BoltFrame& bolt = frame.bolts[i]; bolt.is_broken)
        names.emplace(bolt.number < 0 ? static_cast<int>(i) : bolt.number, bolt.name);
    return names;
  };
  const std::map<int, std::string> before = numbers_of_broken(first);
  std::vector<std::string> broken;
  for (const auto& [number, name] : numbers_of_broken(last))
    if (!before.contains(number)) broken.push_back(fmt::format("{}{}", number + 1, quoted_name(name)));
  if (broken.empty()) return {};
  constexpr std::size_t kNamed = 10;
  const std::size_t all = broken.size(), more = all - std::min(kNamed, all);
  broken.resize(broken.size() - more);
  Facts facts{{{"broken", all}, {"bolts", last.bolts.size()}}, {{"names", fmt::format("{}", fmt::join(broken, ", "))}}};
  if (more > 0) facts.numbers.emplace_back("more", more);
  return {warning_of({"bolts_broke", std::move(facts)}, place)};
}

}  // namespace keyblock
