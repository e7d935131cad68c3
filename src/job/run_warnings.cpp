// Table of step warnings: for each kind of step, its condition and its message.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/run_warnings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "base/counted.hpp"
#include "base/words/plain_number.hpp"
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

std::vector<std::string> start_complaints(const StartReport& start) {
  std::vector<std::string> sentences;
  if (!start.why.empty())
    sentences.push_back(fmt::format("the initial contact forces are one of several possible sets, {}, because {}",
                                    start.made, start.why));
  if (start.misfit > kLargeMisfit)
    sentences.push_back(fmt::format("the initial state leaves {:.1e} of the gaps that it should close", start.misfit));
  if (start.unsolved_steps > 0)
    sentences.push_back(fmt::format("{} of the initial state found no contact forces",
                                    counted(static_cast<std::size_t>(start.unsolved_steps), "step")));
  return sentences;
}

/// Names the contact with the largest imbalance, and the number of contacts.
std::string worst_contact(const StepReport& step, const char* noun) {
  if (step.residual_element == 0) return {};
  return fmt::format(", at the contact of {} {} with {} {} near {}, {} ({} contacts in all, {} closed)", noun,
                     step.residual_element, noun, step.residual_other, plain(step.residual_at.x),
                     plain(step.residual_at.y), step.contacts, step.closed);
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
       [l](const StepReport& s, int, int) {
         return fmt::format(
             "step {}: cut from {:.6g} to {:.6g}, because blocks moved too far or contacts did not settle{}", s.step,
             l.time_step, s.dt, l.cut_stays ? "; the cut stays" : "");
       }},
      {"step_moves_far", [l](const StepReport& s) { return l.is_moving && l.constant && s.displacement_ratio > 1; },
       [](const StepReport& s, int concerned, int steps) {
         return fmt::format(
             "step {}: a block moves {:.3g} times the displacement allowed in a step, as in {} of {} steps", s.step,
             s.displacement_ratio, concerned, steps);
       }},
      {"step_passes_blocks",
       [l](const StepReport& s) { return l.searches_pairs && s.displacement_ratio * l.allowed > l.block_size; },
       [l](const StepReport& s, int concerned, int steps) {
         return fmt::format(
             "step {}: a block moves {}, further than blocks are wide ({}), as in {} of {} steps; it may have passed "
             "through others",
             s.step, plain(s.displacement_ratio * l.allowed, 3), plain(l.block_size, 3), concerned, steps);
       }},
      {"step_above_limit", [l](const StepReport& s) { return !l.constant && s.dt > l.longest_step; },
       [l](const StepReport& s, int, int) {
         return fmt::format(
             "step {}: the automatic step, {:.6g}, exceeds the limit of the file, {:.6g}, as in the Berkeley program",
             s.step, s.dt, l.longest_step);
       }},
      {"step_unresolved", [](const StepReport& s) { return s.unresolved_parts > 0; },
       [](const StepReport& s, int concerned, int steps) {
         return fmt::format(
             "step {}: {} of its parts have the least size (least_step_share) and still exceed the permitted "
             "displacement or error, as in {} of {} steps",
             s.step, s.unresolved_parts, concerned, steps);
       }},
  };
}

std::string out_of_balance(const StepLimits& l, const StepReport& s, double limit, int concerned, int steps) {
  return fmt::format(
      "forces are out of balance by more than {:.0e} of the load in {} of {} steps; the worst is step {} (time "
      "{:.6g}), "
      "by {:.1e}{}",
      limit, concerned, steps, s.step, s.time, s.residual, worst_contact(s, l.noun));
}

/// Returns the kinds of steps whose contacts or equations are not solved well enough.
std::vector<StepKind> kinds_by_solution(const StepLimits& l) {
  return {
      {"unsettled_step_accepted", [](const StepReport& s) { return s.unsettled_contacts > 0; },
       [](const StepReport& s, int, int) {
         return fmt::format("step {}: {} still opened or closed after the last open-close iteration", s.step,
                            counted(static_cast<std::size_t>(s.unsettled_contacts), "contact"));
       }},
      {"deep_penetration", [l](const StepReport& s) { return s.greatest_penetration > l.deep; },
       [l](const StepReport& s, int, int) {
         return fmt::format("step {}: blocks overlap by {:.3g}, {:.0f} times the allowed penetration", s.step,
                            s.greatest_penetration, kDeepPenetrations * s.greatest_penetration / l.deep);
       }},
      {"residual_above_goal",
       [l](const StepReport& s) { return l.is_standard && s.residual > kImbalance && s.residual <= kLargeImbalance; },
       [l](const StepReport& s, int concerned, int steps) {
         return out_of_balance(l, s, kImbalance, concerned, steps);
       },
       [](const StepReport& s) { return s.residual; }},
      {"large_residual",
       [l](const StepReport& s) { return s.residual > (l.is_standard ? kLargeImbalance : kLargeResidual); },
       [l](const StepReport& s, int concerned, int steps) {
         return l.is_standard ? out_of_balance(l, s, kLargeImbalance, concerned, steps)
                              : fmt::format(
                                    "the equations of {} of {} steps are solved to a relative residual of more than "
                                    "{:.0e}; the worst is step {} (time {:.6g}), to {:.1e}",
                                    concerned, steps, kLargeResidual, s.step, s.time, s.residual);
       },
       [](const StepReport& s) { return s.residual; }},
      {"step_in_parts", [](const StepReport& s) { return s.parts >= kManyParts; },
       [](const StepReport& s, int concerned, int steps) {
         return fmt::format(
             "step {} was made in {} parts, near a limit load or too long for elastoplastic rock; as in {} of {} steps",
             s.step, s.parts, concerned, steps);
       }},
      {"overlaps_locked", [](const StepReport& s) { return s.locked_overlaps > 0; },
       [](const StepReport& s, int concerned, int steps) {
         return fmt::format(
             "step {}: overlaps left at impacts, because other contacts block them: {}; as in {} of {} steps", s.step,
             s.locked_overlaps, concerned, steps);
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
  for (const std::vector<StepKind>& kinds : {kinds_by_length(limits), kinds_by_solution(limits)})
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
  for (std::size_t i = 0; i < kinds_.size(); ++i)
    if (seen_[i].count > 0)
      warnings.push_back({kinds_[i].name, place, kinds_[i].sentence(seen_[i].told, seen_[i].count, steps_)});
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
  const std::string how_far = way->share ? fmt::format("about {:.2g} % of the way to equilibrium", 100 * *way->share)
                                         : "no sign of an equilibrium";
  return {
      {"far_from_equilibrium", place,
       fmt::format("static, each step from zero velocity: after {} steps the last, {:.3g} of the one before, shows {}",
                   steps_, way->last_step_ratio, how_far)}};
}

Warnings outcome_warnings(const Prepared& prepared, const RunOutcome& outcome, const Place& place) {
  Warnings warnings;
  for (const std::string& sentence : start_complaints(outcome.start))
    warnings.push_back({"start_settled", place, sentence});
  if (!outcome.start.unbalanced.empty()) warnings.push_back({"start_without_rest", place, outcome.start.unbalanced});
  const auto warn_held = [&](const char* name, const char* what, const TimeCurve& curve) {
    if (curve.times.empty() || curve.times.back() >= outcome.time || curve.values.back() == Point{}) return;
    warnings.push_back({name, curve.place,
                        fmt::format("the table of {}s ends at time {:.6g}, the run at {:.6g}; the last {} stays", what,
                                    curve.times.back(), outcome.time, what)});
  };
  if (prepared.scene.settings.ledger == Bookkeeping::off && !prepared.scene.is_untouched)
    warnings.push_back({"energy_not_judged", place,
                        "ledger=off: the run does not check whether energy came from nothing (energy_limit)"});
  for (const CarriedPoint& point : prepared.scene.model.loading_points)
    warn_held("load_held_after_table", "load", point.curve);
  warn_held("acceleration_held_after_table", "acceleration", prepared.scene.settings.body_acceleration.curve);
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
  return {{"bolts_broke", place,
           fmt::format("{} of {} broke: {}{}; bolts.csv has the frame", all, counted(last.bolts.size(), "bolt"),
                       fmt::join(broken, ", "), more > 0 ? fmt::format(" and {} more", more) : "")}};
}

}  // namespace keyblock
