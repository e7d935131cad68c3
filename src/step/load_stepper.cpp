// Divides load steps, follows the load fraction and transfers the state to the next scene; see load_stepper.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/load_stepper.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "model/continuum.hpp"
#include "step/describe_memory.hpp"

namespace keyblock {
namespace {

// Relative growth of the displacements beyond the last equilibrium in the test for a limit load.
constexpr double kFurtherOn = 0.05;

/// Last equilibrium of a load-controlled search that found none beyond it.
struct LastEquilibrium {
  const LoadedState& at;
  double share;                  ///< load fraction there
  double tried;                  ///< smallest load fraction that found no equilibrium
  const Eigen::VectorXd& speed;  ///< displacement per load fraction
};

// Returns the load fraction at slightly larger displacements on the path of equilibria. A load-controlled search
// without a solution has reached a limit load only if that fraction is no larger.
std::optional<double> share_further_on(const LoadedBodies& bodies, const LastEquilibrium& last) {
  if (last.at.d.norm() == 0) return std::nullopt;
  ArcLength path(bodies);
  NewtonRounds rounds;
  const std::optional<PathPoint> found =
      path.next({last.at, last.share, last.speed, 1}, kFurtherOn * last.at.d.norm(), rounds);
  return found ? std::optional(found->share) : std::nullopt;
}

// Explains why no equilibrium was found. A limit load is claimed only if the path of equilibria leads to no larger
// loads. If edges are driven, weakening rock is still pushed on, so that the end need not be a limit load. `facts`:
// effort spent.
Finding no_equilibrium_beyond(const LoadedBodies& bodies, const LastEquilibrium& last, Facts facts) {
  facts.numbers.emplace_back("load_share", last.share);
  if (std::ranges::any_of(bodies.driven(1), [](double way) { return way != 0; }))
    return {"no_equilibrium_beyond:driven", std::move(facts)};
  PlasticTotals rock;
  bodies.yield().add_totals(last.at.points, rock);
  if (rock.yielded == 0 && last.share > 0) return {"no_equilibrium_beyond:elastic", std::move(facts)};
  const std::optional<double> further = share_further_on(bodies, last);
  if (!further || *further > last.tried) return {"no_equilibrium_beyond", std::move(facts)};
  facts.numbers.insert(facts.numbers.end(), {{"more_percent", 100 * kFurtherOn}, {"share_further_on", *further}});
  return {"limit_load", std::move(facts)};
}

}  // namespace

LoadStepper::LoadStepper(Scene scene)
    : StaticStepper(std::move(scene)),
      bodies_(std::make_unique<LoadedBodies>(*scene_.model.continuum)),
      by_share_(*bodies_),
      now_(bodies_->at_start()) {
  if (scene_.settings.standard.load_control == LoadControl::arc_length) path_.emplace(*bodies_);
  bodies_->begin(now_, nullptr);
  speed_ = Eigen::VectorXd::Zero(now_.d.size());
  way_ = speed_;
  begin_unloaded();
}

LoadStepper::LoadStepper(Scene scene, Archive& saved) : LoadStepper(std::move(scene)) {
  describe(saved);
}

// Maps cover functions through the elements: covers at one mesh node are the same if one element is a part of the
// other.
LoadedState LoadStepper::carried(const LoadedBodies& next, const SceneChange& change) const {
  LoadedState state = next.at_start();
  const CoverBasis& before = bodies_->basis();
  const CoverBasis& after = next.basis();
  for (const ElementIndex e : indices(change.scene.model.elements)) {
    const ElementIndex parent = change.map.elements[e];
    const ElementShape from = before.shape(parent.value), to = after.shape(e.value);
    for (std::size_t a = 0; a < to.functions.size(); ++a)
      state.d.segment<2>(2 * to.functions[a]) = now_.d.segment<2>(2 * from.functions[a]);
    next.yield().carry(e.value, bodies_->yield(), parent.value, now_.points, state.points);
  }
  return state;
}

std::unique_ptr<SceneStepper> LoadStepper::in_next(const SceneChange& change) const {
  auto next = std::make_unique<LoadStepper>(change.scene);
  next->now_ = carried(*next->bodies_, change);
  next->bodies_->begin(next->now_, bodies_.get());
  next->continue_from(*this);
  next->first_step_ = state_.step;
  next->plastic_work_ = plastic_work_;
  next->put_places();
  return next;
}

Stress LoadStepper::stress_at(ElementIndex e, Point start) const {
  if (bodies_->continuum().material(e.value).is_nonlinear())
    return bodies_->yield().stress(now_.d, now_.points, e.value, start);
  return bodies_->elasticity().stress(now_.d, e.value, start);
}

std::optional<PlasticState> LoadStepper::plastic_at(ElementIndex e, Point start) const {
  if (!bodies_->continuum().material(e.value).strength) return std::nullopt;
  return bodies_->yield().plastic_state(now_.points, e.value, start, rotation_of(e, start));
}

std::optional<PlasticTotals> LoadStepper::plastic_totals() const {
  PlasticTotals totals;
  bodies_->yield().add_totals(now_.points, totals);
  if (totals.area == 0) return std::nullopt;
  totals.work = plastic_work_;
  return totals;
}

// put_places reads `now_.d`, so that the tried unknowns replace it for a moment.
void LoadStepper::keep_attempt(const Eigen::VectorXd& d) {
  if (!d.allFinite() || d.size() != now_.d.size()) return;
  const State before = state_;
  const Eigen::VectorXd kept = std::exchange(now_.d, d);
  put_places();
  attempted_ = std::exchange(state_, before);
  now_.d = kept;
}

// Returns the angle of the polar decomposition.
double LoadStepper::rotation_of(ElementIndex e, Point start) const {
  const Eigen::Matrix2d f = bodies_->elasticity().deformation(now_.d, e.value, start);
  return std::atan2(f(1, 0) - f(0, 1), f(0, 0) + f(1, 1));
}

Point LoadStepper::place_of(ElementIndex e, Point start) const {
  return bodies_->elasticity().position(now_.d, e.value, start);
}

int LoadStepper::steps_of_scene() const {
  return std::max(1, scene_.end.steps > 0 ? scene_.end.steps : scene_.settings.step_count - first_step_);
}

Facts LoadStepper::effort_of(const Work& work) {
  return {{{"iterations", work.rounds}, {"cuts", work.cuts}}, {{"cut_by", std::string(in_words(work.cut_by))}}};
}

// Halves the remaining way if the whole of it finds no equilibrium, and doubles the part after each success. A failed
// step leaves no trace in the state.
std::optional<Finding> LoadStepper::advance_to(double share, Work& work) {
  const double whole = share - share_;
  const double least = std::ldexp(whole, -scene_.load_cuts);  // resolution of a limit load
  LoadedState at = now_;
  double reached = share_;
  double part = whole;
  Eigen::VectorXd speed = speed_;
  while (reached < share) {
    const double to = part >= share - reached ? share : reached + part;
    NewtonRounds rounds;
    const Eigen::VectorXd guess = at.d + (to - reached) * speed;
    std::optional<LoadedState> found = by_share_.solve(at, guess, to, rounds);
    work.rounds += rounds.count();
    if (found) {
      speed = (found->d - at.d) / (to - reached);
      work.plastic += bodies_->yield().plastic_work(found->d, at.points, found->points);
      ++work.parts;
      at = std::move(*found);
      reached = to;
      part = std::min(whole, 2 * part);
      work.residuals = std::move(rounds.residuals);
      continue;
    }
    ++work.cuts;
    work.cut_by = rounds.end;
    part = (to - reached) / 2;
    if (part < least) return no_equilibrium_beyond(*bodies_, {at, reached, to, speed}, effort_of(work));
  }
  now_ = std::move(at);
  speed_ = std::move(speed);
  share_ = share;
  plastic_work_ += work.plastic;
  return std::nullopt;
}

// Tries the length of the last step, or twice that after a cut. If a step passes the full loads, it ends at them
// instead.
std::optional<Finding> LoadStepper::advance_along(Work& work) {
  const PathPoint from{now_, share_, way_, share_change_};
  if (length_ == 0) {
    const double of_loads = path_->length_of_loads(from);
    if (of_loads == 0) return advance_to(1, work);
    if (!std::isfinite(of_loads)) return Finding{"no_resistance"};
    length_ = scene_.settings.standard.path_step * of_loads / steps_of_scene();
    part_ = length_;
  }
  for (double part = part_; part >= std::ldexp(length_, -scene_.load_cuts); part /= 2) {
    NewtonRounds rounds;
    std::optional<PathPoint> found = path_->next(from, part, rounds);
    work.rounds += rounds.count();
    if (found && found->share >= 1) return advance_to(1, work);
    if (found) {
      work.residuals = std::move(rounds.residuals);
      part_ = std::min(length_, 2 * part);
      accept(std::move(*found), work);
      return std::nullopt;
    }
    ++work.cuts;
    work.cut_by = rounds.end;
  }
  Facts facts = effort_of(work);
  facts.numbers.emplace_back("load_share", share_);
  return Finding{"no_equilibrium_along_path", std::move(facts)};
}

void LoadStepper::accept(PathPoint found, Work& work) {
  work.parts = 1;
  plastic_work_ += bodies_->yield().plastic_work(found.state.d, now_.points, found.state.points);
  now_ = std::move(found.state);
  share_ = found.share;
  way_ = std::move(found.way);
  share_change_ = found.share_change;
}

std::variant<StepReport, StepFailure> LoadStepper::advance() {
  const int made = state_.step - first_step_;
  if (made == 0)
    if (std::optional<StepFailure> unheld = unheld_pieces()) {
      unheld->kind = FailureKind::accelerates;
      return *unheld;
    }
  Work work;
  const double share = std::min(1.0, static_cast<double>(made + 1) / steps_of_scene());
  if (std::optional<Finding> why = path_ ? advance_along(work) : advance_to(share, work)) {
    keep_attempt(path_ ? path_->last() : by_share_.last());
    StepFailure found = failure(std::move(*why));
    found.kind = FailureKind::no_equilibrium;
    found.passes = work.rounds;
    return found;
  }
  put_places();
  StepReport report = end_step(work.rounds, work.cuts, work.residuals.empty() ? 0 : work.residuals.back());
  report.parts = work.parts;
  report.residuals = std::move(work.residuals);
  return report;
}

void LoadStepper::describe(Archive& archive) {
  archive.values("unknowns", {now_.d.data(), static_cast<std::size_t>(now_.d.size())});
  archive.values("speed", {speed_.data(), static_cast<std::size_t>(speed_.size())});
  archive.table("points", now_.points, [&](YieldState& point) { keyblock::describe(archive, point); });
  bodies_->describe(archive);
  archive.value("share", share_);
  archive.value("first_step", first_step_);
  archive.value("plastic_work", plastic_work_);
  if (path_) {
    archive.values("way", {way_.data(), static_cast<std::size_t>(way_.size())});
    archive.value("share_change", share_change_);
    archive.value("length", length_);
    archive.value("part", part_);
  }
  describe_time(archive);
  if (archive.is_restoring()) put_places();
}

}  // namespace keyblock
