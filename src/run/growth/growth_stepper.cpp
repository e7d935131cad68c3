// Solves, finds the load, solves again under it, and extends the cracks; see growth_stepper.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/growth/growth_stepper.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/decimals.hpp"
#include "fracture/growth.hpp"
#include "model/continuum.hpp"
#include "model/setup/free_pieces.hpp"
#include "model/setup/scale_loads.hpp"
#include "result/describe.hpp"
#include "run/growth/parents.hpp"
#include "run/growth/solution_of.hpp"
#include "run/stages/chain.hpp"
#include "step/scene_steppers.hpp"

namespace keyblock {
namespace {

constexpr int kMostRounds = 6;        // of the search for the load factor
constexpr double kNearEnough = 0.01;  // of the toughness

Scene with_factor(Scene scene, double factor) {
  scene.growth.reset();
  scene.model.continuum = std::make_shared<Continuum>(with_loads(*scene.model.continuum, factor));
  return scene;
}

const Manifold& manifold_of(const Stepper& stepper) {
  return stepper.model().continuum->manifold;
}

/// Returns true if no tip is left, or if no contact holds a piece cut free: statics has no solution beyond.
bool is_end(const Scene& scene) {
  return scene.model.continuum->manifold.tips.empty() ||
         (scene.is_untouched && !free_pieces(*scene.model.continuum).empty());
}

/// Smallest load factor at which something fails: tips, or a crack that starts.
struct Next {
  double factor = 1;
  std::vector<std::size_t> tips;
  std::vector<CrackStart> starts;
};

Next next_of(const std::vector<TipState>& tips, const std::vector<CrackStart>& starts) {
  Next next{1, next_to_go_on(tips), {}};
  double greatest = 0;
  for (const std::size_t i : next.tips) greatest = std::max(greatest, tips[i].equivalent / tips[i].toughness);
  if (!starts.empty() && starts.front().nearness() > greatest) {
    greatest = starts.front().nearness();
    next.tips.clear();
    next.starts = starts;
  }
  if (greatest > 0) next.factor = 1 / greatest;
  return next;
}

bool are_pressed(const std::vector<TipState>& tips) {
  return std::ranges::any_of(tips, [](const TipState& tip) { return tip.has_room && tip.mode_1 < 0; });
}

}  // namespace

GrowthStepper::GrowthStepper(Scene first) : first_(std::move(first)), cracks_(first_.growth->cracks) {
  front_.cracks = cracks_;
  next_number_ = static_cast<int>(first_.model.elements.size());
  now_ = scene_stepper(with_factor(first_, 1));
  state_ = now_->state();
}

GrowthStepper::GrowthStepper(Scene first, Archive& saved) : first_(std::move(first)) {
  describe_growth(saved);
  saved.group("scene", [&] {
    Scene scene = scene_with(front_.cracks, load_factor_);
    restore_names(saved, scene.model);
    now_ = restored_scene_stepper(std::move(scene), saved);
  });
  const int step = state_.step;
  const double time = state_.time;
  state_ = now_->state();
  state_.step = step;
  state_.time = time;
}

void GrowthStepper::save(Archive& archive) {
  describe_growth(archive);
  archive.group("scene", [&] {
    save_names(archive, now_->model());
    now_->save(archive);
  });
}

void GrowthStepper::describe_growth(Archive& archive) {
  archive.value("step", state_.step);
  archive.value("time", state_.time);
  archive.value("load_factor", load_factor_);
  archive.value("is_done", is_done_);
  archive.value("next_number", next_number_);
  describe(archive, "cracks", cracks_);
  describe(archive, front_);
  archive.group("notes", [&] { describe(archive, notes_); });
}

Scene GrowthStepper::scene_with(const std::vector<CrackPlan>& cracks, double factor) const {
  return with_factor(first_.growth->remade(cracks, {}), factor);
}

std::variant<GrowthStepper::Solved, StepFailure> GrowthStepper::solved(const std::vector<CrackPlan>& cracks,
                                                                       double factor) const {
  Solved result;
  try {
    Scene scene = scene_with(cracks, factor);
    result.next_number = next_number_;
    name_elements(now_->model(), scene.model, parents_by_place(now_->model(), scene.model), result.next_number);
    result.stepper = scene_stepper(std::move(scene));
  } catch (const InputError& error) {
    return failure({"cracks_cannot_go_on", {{}, {{"input", error.what()}}}});
  }
  std::variant<StepReport, StepFailure> made = result.stepper->advance();
  if (const auto* why = std::get_if<StepFailure>(&made)) return *why;
  result.report = std::get<StepReport>(made);
  const CoverSolution solution = *solution_of(*result.stepper);
  result.tips = tips_of(solution, cracks, first_.growth->plan.criterion);
  result.starts = crack_starts(solution);
  return result;
}

// A tip just before a line has no field of its own: it extends to the line at once.
std::optional<StepFailure> GrowthStepper::unfit_tip(const Stepper& solved, std::vector<TipState>& tips) const {
  for (std::size_t i = 0; i < tips.size(); ++i) {
    if (tips[i].has_room) continue;
    const CrackTip& tip = tip_of(manifold_of(solved), tips[i]);
    if (way_through(manifold_of(solved), tip, first_.growth->plan.increment)) {
      tips[i].goes_on = true;
      continue;
    }
    return failure({"tip_cannot_go_on",
                    {{{"tip", i + 1}, {"room", tip.room}},
                     {{"name", words_of(tips[i], i)}, {"nearest", tip.nearest}},
                     {},
                     {{{tips[i].at.x, tips[i].at.y}}}}});
  }
  return std::nullopt;
}

std::vector<CrackPlan> GrowthStepper::further(const std::vector<double>& more) const {
  return prolonged(front_, manifold_of(*now_), first_.growth->plan.increment, more);
}

std::vector<double> GrowthStepper::corrections(const std::vector<CrackPlan>& trial) const {
  auto tried = solved(trial, load_factor_);
  if (std::holds_alternative<StepFailure>(tried)) return std::vector<double>(front_.tips.size(), 0);
  return kink_corrections(front_, std::get<Solved>(tried).tips);
}

void GrowthStepper::put_next() {
  const auto ends_with_cracks = [&] {
    try {
      return is_end(first_.growth->remade(cracks_, {}));
    } catch (const InputError&) {
      return false;  // the next step reports why these cracks are impossible
    }
  };
  cracks_ = further(std::vector<double>(front_.tips.size(), 0));
  is_done_ = ends_with_cracks();
  if (is_done_ || !first_.growth->plan.has_corrector) return;
  cracks_ = further(corrections(cracks_));
  is_done_ = ends_with_cracks();
}

std::string GrowthStepper::why_done() const {
  if (!is_done_) return {};
  std::vector<std::string> ends;
  const auto add = [&](std::size_t c, Point end) {
    ends.push_back(fmt::format("crack {} to ({:.6g}, {:.6g})", c + 1, end.x, end.y));
  };
  for (std::size_t c = 0; c < cracks_.size(); ++c) {
    const std::vector<Point>& is = cracks_[c].along;
    if (c >= front_.cracks.size()) {  // from the tip of a joint, or in intact rock
      add(c, is.back());
      continue;
    }
    const std::vector<Point>& was = front_.cracks[c].along;
    if (was.front() != is.front()) add(c, is.front());
    if (was.back() != is.back()) add(c, is.back());
  }
  return fmt::format("after the next increment, {}, no tip is left, or a piece is cut free that nothing holds",
                     fmt::join(ends, " and "));
}

// Proportional loads of elastic rock need one division; contact with gaps or large rotation needs a few more.
std::variant<GrowthStepper::Solved, StepFailure> GrowthStepper::solved_at_toughness(
    double& factor, const std::vector<std::size_t>& tips) const {
  for (int round = 0; round < kMostRounds; ++round) {
    auto made = solved(cracks_, factor);
    if (std::holds_alternative<StepFailure>(made) || tips.empty()) return made;
    double greatest = 0;
    const std::vector<TipState>& found = std::get<Solved>(made).tips;
    for (const std::size_t i : tips)
      if (i < found.size() && found[i].toughness > 0)
        greatest = std::max(greatest, found[i].equivalent / found[i].toughness);
    if (std::abs(greatest - 1) <= kNearEnough) return made;
    if (!(greatest > 0)) break;
    factor /= greatest;
  }
  return failure({"no_load_factor", {{{"percent", 100 * kNearEnough}}}});
}

std::variant<StepReport, StepFailure> GrowthStepper::advance() {
  auto unit = solved(cracks_, 1);
  if (const auto* why = std::get_if<StepFailure>(&unit)) return *why;
  auto& under_unit = std::get<Solved>(unit);
  if (auto why = unfit_tip(*under_unit.stepper, under_unit.tips)) return *why;
  const bool goes_through = std::ranges::any_of(under_unit.tips, &TipState::goes_on);
  Next next = next_of(under_unit.tips, under_unit.starts);
  if (!goes_through && next.tips.empty() && next.starts.empty())
    return failure({are_pressed(under_unit.tips) ? "no_tip_extends:pressed" : "no_tip_extends"});
  const bool is_loaded = !next.tips.empty() || !next.starts.empty();
  double factor = is_loaded ? next.factor : load_factor_;
  auto loaded = solved_at_toughness(factor, next.tips);
  if (const auto* why = std::get_if<StepFailure>(&loaded)) return *why;
  auto& under_load = std::get<Solved>(loaded);
  for (std::size_t i = 0; i < under_load.tips.size(); ++i) under_load.tips[i].goes_on = under_unit.tips[i].goes_on;
  if (goes_through) next.starts.clear();
  if (!goes_through)
    for (const std::size_t i : next.tips) under_load.tips[i].goes_on = true;
  StepReport report = under_load.report;
  report.passes += under_unit.report.passes;
  now_ = std::move(under_load.stepper);
  next_number_ = under_load.next_number;
  const int step = state_.step + 1;
  const CrackFront before = std::exchange(front_, {cracks_, std::move(under_load.tips), next.starts});
  note_bends(notes_, step, before, front_);
  note_front(notes_, step, front_);
  load_factor_ = factor;
  state_ = now_->state();
  state_.step = step;
  state_.time = short_decimal(step * first_.settings.time_step);
  report.step = step;
  report.time = state_.time;
  if (step < first_.settings.step_count) put_next();
  return report;
}

}  // namespace keyblock
