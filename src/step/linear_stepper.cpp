// A scene is solved in its first step; the steps after it find the same.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/linear_stepper.hpp"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "model/continuum.hpp"
#include "model/setup/free_pieces.hpp"
#include "step/static_places.hpp"

namespace keyblock {

LinearStepper::LinearStepper(Scene scene) : scene_(std::move(scene)) {
  put_places();
  unloaded_ = places_of(state_);
}

LinearStepper::LinearStepper(Scene scene, Archive& saved) : LinearStepper(std::move(scene)) {
  describe(saved);
}

std::unique_ptr<SceneStepper> LinearStepper::in_next(const SceneChange& change) const {
  auto next = std::make_unique<LinearStepper>(change.scene);
  next->state_.step = state_.step;
  next->state_.time = state_.time;
  next->state_.dt = state_.dt;
  return next;
}

Stress LinearStepper::stress_at(ElementIndex e, Point start) const {
  return solution_ ? keyblock::stress_at(continuum(), *solution_, e.value, start)
                   : continuum().initial_stress_at(e.value, start);
}

void LinearStepper::put_places() {
  keyblock::put_places(
      scene_,
      {[&](ElementIndex e, Point start) { return solution_ ? start + solution_->displacement(e.value, start) : start; },
       [&](ElementIndex e, Point start) { return stress_at(e, start); }},
      state_);
}

std::variant<StepReport, StepFailure> LinearStepper::advance() {
  const int step = state_.step + 1;
  const bool solves = !solution_;
  if (solves) {
    const std::vector<FreePiece> free = free_pieces(continuum());
    if (!free.empty())
      return StepFailure{fmt::format("load step {}: {}{}", step, to_string(free.front()),
                                     free.size() > 1 ? fmt::format(" (and {} more)", free.size() - 1) : ""),
                         {}};
    try {
      solution_ = solve_static(continuum());
    } catch (const NotPositiveDefinite& error) {
      return StepFailure{fmt::format("load step {}: {}", step, error.what()), {}};
    }
    put_places();
  }
  state_.step = step;
  state_.dt = scene_.settings.time_step;
  state_.time = step * state_.dt;
  StepReport report;
  report.step = step;
  report.time = state_.time;
  report.dt = state_.dt;
  report.passes = solves ? 1 : 0;
  report.residual = solution_->solution.residual;
  return report;
}

std::optional<ForceBalance> LinearStepper::forces() const {
  return solution_ ? std::optional(balance_of(continuum(), *solution_)) : std::nullopt;
}

// The state is that of the solution, but for its step and times.
void LinearStepper::describe(Archive& archive) {
  bool is_solved = solution_.has_value();
  archive.value("is_solved", is_solved);
  if (is_solved) describe_solution(archive);
  if (archive.is_restoring()) put_places();
  archive.value("step", state_.step);
  archive.value("time", state_.time);
  archive.value("dt", state_.dt);
}

void LinearStepper::describe_solution(Archive& archive) {
  if (archive.is_restoring())
    solution_.emplace(CoverBasis(continuum().manifold, continuum().functions), SparseSolution());
  SparseSolution& found = solution_->solution;
  if (archive.is_restoring()) found.x.setZero(2 * solution_->basis.function_count());
  archive.values("unknowns", {found.x.data(), static_cast<std::size_t>(found.x.size())});
  archive.value("residual", found.residual);
}

}  // namespace keyblock
